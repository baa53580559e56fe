# The seven figures (figure 4.5)
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-4.5.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,362 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,9.59cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-4.5.'.format
data = 'figure-4.5.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 96 mm
set label 'pentahedron' at screen 0.50000,0.96870 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1, 1 solution
set label '1 solution' at screen 0.12284,0.52079 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.02081,0.70563 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.02081,0.62623 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.08878,0.62934 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.08759,0.70510 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.12342,0.86207 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.22575,0.67891 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.00287; set rmargin at screen 0.24282
set bmargin at screen 0.53957; set tmargin at screen 0.94262
set xrange [-0.388438302:2.53406786]; set yrange [-1.01609577:1.68827276]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 1 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 2 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 3 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 4 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 5 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 6 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 7 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 8 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 9 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 10 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 11 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 2, 1 solution
set label '1 solution' at screen 0.37428,0.52079 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.29264,0.63144 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.29885,0.55735 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.35637,0.56732 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.36742,0.64950 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.45692,0.73321 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.37084,0.92163 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.25431; set rmargin at screen 0.49425
set bmargin at screen 0.53957; set tmargin at screen 0.94262
set xrange [-0.635330064:2.2871761]; set yrange [-0.616465349:2.08790318]
set border 0; unset xtics; unset ytics
plot data index 12 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 13 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 14 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 15 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 16 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 17 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 18 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 19 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 20 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 21 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 22 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 3, 1 solution
set label '1 solution' at screen 0.62572,0.52079 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.66950,0.68596 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.67303,0.59115 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.71315,0.62892 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.61118,0.62629 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.65476,0.82240 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.54175,0.89094 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.50575; set rmargin at screen 0.74569
set bmargin at screen 0.53957; set tmargin at screen 0.94262
set xrange [-2.03755834:0.884947819]; set yrange [-0.821695576:1.88267295]
set border 0; unset xtics; unset ytics
plot data index 23 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 24 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 25 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 26 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 27 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 28 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 29 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 30 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 31 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 32 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 33 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 34 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 4, 1 solution
set label '1 solution' at screen 0.87716,0.52079 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.93366,0.70981 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.91470,0.60772 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.98628,0.60790 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.97010,0.66352 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.88872,0.77528 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.76803,0.87429 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.75718; set rmargin at screen 0.99713
set bmargin at screen 0.53957; set tmargin at screen 0.94262
set xrange [-1.9615638:0.960942355]; set yrange [-0.954299774:1.75006875]
set border 0; unset xtics; unset ytics
plot data index 35 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 36 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 37 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 38 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 39 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 40 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 41 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 42 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 43 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 44 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 45 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 46 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 1, 1 solution
set label '1 solution' at screen 0.12284,0.04486 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.10316,0.17615 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.10691,0.08142 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.17418,0.11506 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.07239,0.11302 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.08117,0.27907 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.15508,0.46334 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.00287; set rmargin at screen 0.24282
set bmargin at screen 0.06364; set tmargin at screen 0.48114
set xrange [-1.36000033:1.56250583]; set yrange [-0.616465349:2.1848431]
set border 0; unset xtics; unset ytics
plot data index 47 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 48 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 49 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 50 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 51 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 52 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 53 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 54 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 55 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 56 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 57 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 58 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 2, 1 solution, flat
set label '1 solution, flat' at screen 0.37428,0.04486 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.28437,0.31973 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.27394,0.23102 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.35933,0.23079 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.26951,0.25777 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.35030,0.32011 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.47806,0.27740 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.25431; set rmargin at screen 0.49425
set bmargin at screen 0.06364; set tmargin at screen 0.48114
set xrange [-0.409114112:2.51339205]; set yrange [-1.55770556:1.24360289]
set border 0; unset xtics; unset ytics
plot data index 59 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 60 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 61 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 62 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 63 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 64 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 65 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 66 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 67 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 68 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 69 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 3, 1 solution, flat
set label '1 solution, flat' at screen 0.62572,0.04486 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.72388,0.31516 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.71345,0.22646 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.73267,0.28435 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.63732,0.31000 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.61905,0.22030 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.51976,0.28214 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.50575; set rmargin at screen 0.74569
set bmargin at screen 0.06364; set tmargin at screen 0.48114
set xrange [-2.48684294:0.435663222]; set yrange [-1.58948481:1.21182363]
set border 0; unset xtics; unset ytics
plot data index 70 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 71 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 72 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 73 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 74 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 75 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 76 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 77 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 78 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 79 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 80 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
