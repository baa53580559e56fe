# A hexahedron inscribed in a tetrahedron O, P0, P3, K of which two corners are cut off: dashed, what is left of its edges, and the line of its sixth edge
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-5.6.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 306,408 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.10cm,10.80cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-5.6.'.format
data = 'figure-5.6.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 81 mm x 108 mm
set label 'hexahedron-in-tetrahedron' at screen 0.50000,0.97222 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.50000,0.00648 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.19407,0.37775 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.34360,0.23384 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.68740,0.24506 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.80593,0.36562 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.59304,0.48299 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.65128,0.61862 center font ',7' tc rgb '#202020' noenhanced front
set label 'P6' at screen 0.31511,0.62469 center font ',7' tc rgb '#202020' noenhanced front
set label 'P7' at screen 0.39609,0.46986 center font ',7' tc rgb '#202020' noenhanced front
set label 'O' at screen 0.52643,0.10813 center font ',7' tc rgb '#202020' noenhanced front
set label 'K' at screen 0.45221,0.86409 center font ',7' tc rgb '#202020' noenhanced front
set label 'OK' at screen 0.48698,0.09328 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.00617; set rmargin at screen 0.99383
set bmargin at screen 0.02315; set tmargin at screen 0.94907
set xrange [-0.774148153:2.73921098]; set yrange [-1.68189522:2.7098037]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 1 using 1:2 with lines lw 0.5 dt 2 lc rgb '#808080', \
  data index 2 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 3 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 4 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 5 using 1:2 with lines lw 0.836 lc rgb '#5CA5CE', \
  data index 6 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 7 using 1:2 with lines lw 0.924 lc rgb '#3D94C4', \
  data index 8 using 1:2 with lines lw 1.01 lc rgb '#1F83BB', \
  data index 9 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 10 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 11 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 12 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 13 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 14 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
