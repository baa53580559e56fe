# The circles that touch the sides of a triangle
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' triangle.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,222 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,5.87cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'triangle.'.format
data = 'triangle.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 59 mm
set label 'circles-of-a-triangle' at screen 0.50000,0.94887 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1, 32 solutions
set label '32 solutions' at screen 0.12284,0.07329 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.08014,0.41980 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.17000,0.44494 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.12969,0.59259 center font ',7' tc rgb '#202020' noenhanced front
set label 'l' at screen 0.15467,0.42411 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'm' at screen 0.14200,0.57769 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'n' at screen 0.09525,0.42869 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'k' at screen 0.13591,0.49712 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.00287; set rmargin at screen 0.24282
set bmargin at screen 0.10397; set tmargin at screen 0.90626
set xrange [-5.80937484:10.8093748]; set yrange [-8.16821554:10.5682155]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with lines lw 0.84 lc rgb '#143653', \
  data index 1 using 1:2 with lines lw 0.66 lc rgb '#0072B2', \
  data index 2 using 1:2 with points pt 7 ps 0.252 lc rgb '#143653'
unset label; unset arrow

# line 1, column 2, 32 solutions
set label '32 solutions' at screen 0.37428,0.07329 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.33606,0.71370 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.42694,0.71370 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.39487,0.82485 center font ',7' tc rgb '#202020' noenhanced front
set label 'l' at screen 0.27928,0.71560 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'm' at screen 0.37385,0.80200 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'n' at screen 0.26962,0.56135 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'k' at screen 0.45224,0.43663 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.25431; set rmargin at screen 0.49425
set bmargin at screen 0.10397; set tmargin at screen 0.90626
set xrange [-6.30937484:10.3093748]; set yrange [-13.5922155:5.14421554]
set border 0; unset xtics; unset ytics
plot data index 3 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 4 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 5 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 3, 32 solutions
set label '32 solutions' at screen 0.62572,0.07329 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.60915,0.40437 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.70004,0.40437 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.66796,0.51552 center font ',7' tc rgb '#202020' noenhanced front
set label 'l' at screen 0.55638,0.40627 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'm' at screen 0.63037,0.67217 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'n' at screen 0.61561,0.32628 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'k' at screen 0.63875,0.50848 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.50575; set rmargin at screen 0.74569
set bmargin at screen 0.10397; set tmargin at screen 0.90626
set xrange [-7.80937484:8.80937484]; set yrange [-6.36821554:12.3682155]
set border 0; unset xtics; unset ytics
plot data index 6 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 7 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 8 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 4, 32 solutions
set label '32 solutions' at screen 0.87716,0.07329 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.81006,0.44719 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.90094,0.44719 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.86887,0.55834 center font ',7' tc rgb '#202020' noenhanced front
set label 'l' at screen 0.82624,0.38985 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'm' at screen 0.85286,0.62962 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'n' at screen 0.88979,0.61997 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'k' at screen 0.92630,0.50708 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.75718; set rmargin at screen 0.99713
set bmargin at screen 0.10397; set tmargin at screen 0.90626
set xrange [-4.30937484:12.3093748]; set yrange [-7.36821554:11.3682155]
set border 0; unset xtics; unset ytics
plot data index 9 using 1:2 with lines lw 1.31 lc rgb '#143653', \
  data index 10 using 1:2 with lines lw 1.03 lc rgb '#0072B2', \
  data index 11 using 1:2 with points pt 7 ps 0.392 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
