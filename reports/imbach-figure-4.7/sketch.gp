# (a) The sketch
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' sketch.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 306,296 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.10cm,7.83cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'sketch.'.format
data = 'sketch.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 81 mm x 78 mm
set label 'octahedron' at screen 0.50000,0.96169 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.50000,0.00894 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.31976,0.39102 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.76228,0.05370 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.96497,0.65479 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.25277,0.09117 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.02946,0.13004 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.71814,0.90799 center font ',7' tc rgb '#202020' noenhanced front
set label 'h9' at screen 0.17166,0.15693 center font ',7' tc rgb '#606060' noenhanced front
set label 'h3' at screen 0.32665,0.32188 center font ',7' tc rgb '#606060' noenhanced front
set label 'h5' at screen 0.51312,0.12328 center font ',7' tc rgb '#606060' noenhanced front
set label 'h0' at screen 0.56686,0.25812 center font ',7' tc rgb '#606060' noenhanced front
set label 'h2' at screen 0.81447,0.36724 center font ',7' tc rgb '#606060' noenhanced front
set label 'h4' at screen 0.35401,0.44124 center font ',7' tc rgb '#606060' noenhanced front
set label 'h1' at screen 0.63554,0.53273 center font ',7' tc rgb '#606060' noenhanced front
set label 'h6' at screen 0.75437,0.42678 center font ',7' tc rgb '#606060' noenhanced front
set label 'h7' at screen 0.59051,0.39839 center font ',7' tc rgb '#606060' noenhanced front
set label 'h11' at screen 0.53819,0.50406 center font ',7' tc rgb '#606060' noenhanced front
set label 'h10' at screen 0.35248,0.53977 center font ',7' tc rgb '#606060' noenhanced front
set label 'h8' at screen 0.51366,0.36199 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00617; set rmargin at screen 0.99383
set bmargin at screen 0.03193; set tmargin at screen 0.92976
set xrange [-0.405924949:0.754652363]; set yrange [-0.397870054:0.621997907]
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
  data index 9 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
