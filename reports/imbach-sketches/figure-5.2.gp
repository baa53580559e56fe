# Sketch of the pentahedron, problem 2, with the parameters of its lengths
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-5.2.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 306,361 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.10cm,9.55cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-5.2.'.format
data = 'figure-5.2.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 81 mm x 95 mm
set label 'pentahedron' at screen 0.50000,0.96858 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.50000,0.00733 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.02972,0.32254 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.97241,0.22224 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.84171,0.47982 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.84191,0.92454 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.50987,0.46190 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.35540,0.04406 center font ',7' tc rgb '#202020' noenhanced front
set label 'h8' at screen 0.67401,0.49031 center font ',7' tc rgb '#606060' noenhanced front
set label 'h1' at screen 0.90472,0.36517 center font ',7' tc rgb '#606060' noenhanced front
set label 'h6' at screen 0.23331,0.21427 center font ',7' tc rgb '#606060' noenhanced front
set label 'h2' at screen 0.79173,0.69079 center font ',7' tc rgb '#606060' noenhanced front
set label 'h5' at screen 0.41638,0.26048 center font ',7' tc rgb '#606060' noenhanced front
set label 'h4' at screen 0.65503,0.69413 center font ',7' tc rgb '#606060' noenhanced front
set label 'h7' at screen 0.64329,0.17061 center font ',7' tc rgb '#606060' noenhanced front
set label 'h0' at screen 0.50295,0.29610 center font ',7' tc rgb '#606060' noenhanced front
set label 'h3' at screen 0.42177,0.63129 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00617; set rmargin at screen 0.99383
set bmargin at screen 0.02618; set tmargin at screen 0.94239
set xrange [-0.119954701:2.10391679]; set yrange [-0.786546004:1.64516223]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 1 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 2 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 3 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 4 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 5 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 6 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 7 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 8 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 9 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 10 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
