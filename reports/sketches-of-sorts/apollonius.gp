# The eight circles x that touch three circles
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' apollonius.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,357 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,9.44cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'apollonius.'.format
data = 'apollonius.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 94 mm
set label 'apollonius' at screen 0.50000,0.96822 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1, 4 solutions
set label '4 solutions' at screen 0.12284,0.56261 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.05961,0.66137 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.16409,0.67302 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.13922,0.86247 center font ',7' tc rgb '#202020' noenhanced front
set label 'a' at screen 0.10494,0.69777 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'b' at screen 0.18188,0.71294 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'c' at screen 0.15602,0.84124 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'x' at screen 0.18733,0.76560 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.00287; set rmargin at screen 0.24282
set bmargin at screen 0.58168; set tmargin at screen 0.94173
set xrange [-5.48261678:11.2529254]; set yrange [-3.89593436:9.72638564]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 1 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 2 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 2, 4 solutions
set label '4 solutions' at screen 0.37428,0.56261 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.33485,0.65635 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.41746,0.66578 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.39260,0.85522 center font ',7' tc rgb '#202020' noenhanced front
set label 'a' at screen 0.35661,0.70234 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'b' at screen 0.43660,0.67922 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'c' at screen 0.40940,0.83400 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'x' at screen 0.38689,0.73576 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.25431; set rmargin at screen 0.49425
set bmargin at screen 0.58168; set tmargin at screen 0.94173
set xrange [-5.61777109:11.1177711]; set yrange [-3.6217723:10.0005477]
set border 0; unset xtics; unset ytics
plot data index 3 using 1:2 with lines lw 1.31 lc rgb '#143653', \
  data index 4 using 1:2 with lines lw 1.03 lc rgb '#0072B2', \
  data index 5 using 1:2 with points pt 7 ps 0.393 lc rgb '#143653'
unset label; unset arrow

# line 1, column 3, 4 solutions
set label '4 solutions' at screen 0.62572,0.56261 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.58399,0.66360 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.66660,0.67303 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.64173,0.86248 center font ',7' tc rgb '#202020' noenhanced front
set label 'a' at screen 0.60745,0.69778 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'b' at screen 0.66728,0.74152 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'c' at screen 0.65853,0.84125 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'x' at screen 0.69032,0.71193 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.50575; set rmargin at screen 0.74569
set bmargin at screen 0.58168; set tmargin at screen 0.94173
set xrange [-5.45719905:11.2783431]; set yrange [-3.89631677:9.72600323]
set border 0; unset xtics; unset ytics
plot data index 6 using 1:2 with lines lw 1.39 lc rgb '#143653', \
  data index 7 using 1:2 with lines lw 1.09 lc rgb '#0072B2', \
  data index 8 using 1:2 with points pt 7 ps 0.416 lc rgb '#143653'
unset label; unset arrow

# line 1, column 4, 4 solutions
set label '4 solutions' at screen 0.87716,0.56261 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.84627,0.64264 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.92888,0.65208 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.90401,0.84152 center font ',7' tc rgb '#202020' noenhanced front
set label 'a' at screen 0.85203,0.70926 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'b' at screen 0.94802,0.66552 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'c' at screen 0.92081,0.82030 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'x' at screen 0.94241,0.79373 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.75718; set rmargin at screen 0.99713
set bmargin at screen 0.58168; set tmargin at screen 0.94173
set xrange [-6.21356472:10.5219775]; set yrange [-3.10340524:10.5189148]
set border 0; unset xtics; unset ytics
plot data index 9 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 10 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 11 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 1, 4 solutions
set label '4 solutions' at screen 0.12284,0.04556 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.06159,0.18596 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.14420,0.19539 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.11933,0.38484 center font ',7' tc rgb '#202020' noenhanced front
set label 'a' at screen 0.08484,0.22315 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'b' at screen 0.16334,0.20883 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'c' at screen 0.13613,0.36361 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'x' at screen 0.18978,0.29710 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.00287; set rmargin at screen 0.24282
set bmargin at screen 0.06463; set tmargin at screen 0.52235
set xrange [-4.09524553:12.6402967]; set yrange [-5.38720197:11.9304142]
set border 0; unset xtics; unset ytics
plot data index 12 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 13 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 14 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 2, 4 solutions
set label '4 solutions' at screen 0.37428,0.04556 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.33484,0.21514 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.41745,0.22457 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.39258,0.41402 center font ',7' tc rgb '#202020' noenhanced front
set label 'a' at screen 0.35830,0.24932 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'b' at screen 0.43659,0.23801 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'c' at screen 0.40939,0.39279 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'x' at screen 0.43632,0.26856 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.25431; set rmargin at screen 0.49425
set bmargin at screen 0.06463; set tmargin at screen 0.52235
set xrange [-5.61683259:11.1187096]; set yrange [-6.49124363:10.8263725]
set border 0; unset xtics; unset ytics
plot data index 15 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 16 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 17 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 3, 4 solutions
set label '4 solutions' at screen 0.62572,0.04556 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.57619,0.17548 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.67709,0.19756 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.65222,0.38701 center font ',7' tc rgb '#202020' noenhanced front
set label 'a' at screen 0.61794,0.22231 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'b' at screen 0.69623,0.21100 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'c' at screen 0.66902,0.36578 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'x' at screen 0.64149,0.25921 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.50575; set rmargin at screen 0.74569
set bmargin at screen 0.06463; set tmargin at screen 0.52235
set xrange [-6.18875881:10.5467834]; set yrange [-5.4694204:11.8481958]
set border 0; unset xtics; unset ytics
plot data index 18 using 1:2 with lines lw 1.31 lc rgb '#143653', \
  data index 19 using 1:2 with lines lw 1.03 lc rgb '#0072B2', \
  data index 20 using 1:2 with points pt 7 ps 0.393 lc rgb '#143653'
unset label; unset arrow

# line 2, column 4, 4 solutions
set label '4 solutions' at screen 0.87716,0.04556 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.86395,0.13516 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.96983,0.13503 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.94497,0.32447 center font ',7' tc rgb '#202020' noenhanced front
set label 'a' at screen 0.91068,0.15977 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'b' at screen 0.98897,0.14847 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'c' at screen 0.96177,0.30325 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'x' at screen 0.97888,0.30528 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.75718; set rmargin at screen 0.99713
set bmargin at screen 0.06463; set tmargin at screen 0.52235
set xrange [-9.0700336:7.66550859]; set yrange [-3.10340524:14.2142109]
set border 0; unset xtics; unset ytics
plot data index 21 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 22 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 23 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
