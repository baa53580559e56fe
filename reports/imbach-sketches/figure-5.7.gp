# The parallelepiped that the vectors from P0 to P1, P2 and P3 span, of which the constraint's volume v is a sixth
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-5.7.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 306,296 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.10cm,7.82cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-5.7.'.format
data = 'figure-5.7.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 81 mm x 78 mm
set label 'tetrahedron-volume' at screen 0.50000,0.96164 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.50000,0.00895 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.02972,0.53833 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.24400,0.13765 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.63427,0.44563 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.19785,0.90786 center font ',7' tc rgb '#202020' noenhanced front
set label 'v' at screen 0.50000,0.50943 center font ',7' tc rgb '#606060' noenhanced front
set label 'h2' at screen 0.10404,0.72150 center font ',7' tc rgb '#606060' noenhanced front
set label 'h0' at screen 0.18322,0.36803 center font ',7' tc rgb '#606060' noenhanced front
set label 'h3' at screen 0.40786,0.33578 center font ',7' tc rgb '#606060' noenhanced front
set label 'h1' at screen 0.33452,0.52130 center font ',7' tc rgb '#606060' noenhanced front
set label 'h4' at screen 0.42654,0.68921 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00617; set rmargin at screen 0.99383
set bmargin at screen 0.03197; set tmargin at screen 0.92967
set xrange [-0.143519248:2.51722151]; set yrange [-1.31710082:1.01790521]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with lines lw 0.5 dt 2 lc rgb '#606060', \
  data index 1 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 2 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 3 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 4 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 5 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 6 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 7 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 8 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 9 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 10 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
