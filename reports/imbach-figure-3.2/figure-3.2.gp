# The figures on the path of the sketch, as figure 3.2 has them
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-3.2.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 306,1026 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.10cm,27.15cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-3.2.'.format
data = 'figure-3.2.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 81 mm x 272 mm
set label 'octahedron' at screen 0.50000,0.98895 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1, 1 solution
set label '1 solution' at screen 0.50000,0.70999 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.66096,0.72290 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.74202,0.80005 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.02946,0.76563 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.29923,0.97346 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.29193,0.89227 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.97054,0.91075 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.00617; set rmargin at screen 0.99383
set bmargin at screen 0.71661; set tmargin at screen 0.97975
set xrange [-1.07203973:0.563940751]; set yrange [-0.0817990239:1.37937702]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 1 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 2 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 3 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 4 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 5 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 6 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 7 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 8 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 9 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 10 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 11 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 1, 1 solution
set label '1 solution' at screen 0.50000,0.48750 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.79936,0.61001 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.85084,0.68855 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.14172,0.65454 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.75937,0.63518 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.23501,0.50041 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.25895,0.60932 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.00617; set rmargin at screen 0.99383
set bmargin at screen 0.49413; set tmargin at screen 0.69599
set xrange [-1.26108824:0.374892236]; set yrange [-0.657602973:0.463345994]
set border 0; unset xtics; unset ytics
plot data index 12 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 13 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 14 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 15 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 16 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 17 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 18 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 19 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 20 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 21 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 22 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 3, column 1, 1 solution
set label '1 solution' at screen 0.50000,0.27878 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.79192,0.31638 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.85084,0.39966 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.14385,0.36311 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.74573,0.33055 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.81584,0.46723 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.28859,0.29498 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.00617; set rmargin at screen 0.99383
set bmargin at screen 0.28541; set tmargin at screen 0.47351
set xrange [-1.26108824:0.374892236]; set yrange [-0.212420852:0.832093641]
set border 0; unset xtics; unset ytics
plot data index 23 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 24 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 25 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 26 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 27 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 28 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 29 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 30 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 31 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 32 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 4, column 1, 1 solution
set label '1 solution' at screen 0.50000,0.01584 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.79192,0.02991 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.85828,0.10845 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.14359,0.07148 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.29057,0.25851 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.71096,0.22294 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.23813,0.05164 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.00617; set rmargin at screen 0.99383
set bmargin at screen 0.02246; set tmargin at screen 0.26479
set xrange [-1.26108824:0.374892236]; set yrange [-0.0817990239:1.2638294]
set border 0; unset xtics; unset ytics
plot data index 33 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 34 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 35 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 36 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 37 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 38 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 39 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 40 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 41 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 42 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 43 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
