# Sketch of the pentahedron's edges with all points in a plane, with the parameters of their lengths
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-5.3.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 306,370 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.10cm,9.79cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-5.3.'.format
data = 'figure-5.3.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 81 mm x 98 mm
set label 'pentahedron-flat' at screen 0.50000,0.96937 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.50000,0.00715 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.03503,0.04617 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.73654,0.04617 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.97241,0.53223 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.10835,0.92644 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.74210,0.45687 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.25790,0.24261 center font ',7' tc rgb '#202020' noenhanced front
set label 'h8' at screen 0.81906,0.51924 center font ',7' tc rgb '#606060' noenhanced front
set label 'h6' at screen 0.15343,0.16685 center font ',7' tc rgb '#606060' noenhanced front
set label 'h7' at screen 0.51199,0.16882 center font ',7' tc rgb '#606060' noenhanced front
set label 'h5' at screen 0.48270,0.37040 center font ',7' tc rgb '#606060' noenhanced front
set label 'h1' at screen 0.79775,0.30550 center font ',7' tc rgb '#606060' noenhanced front
set label 'h0' at screen 0.38578,0.08411 center font ',7' tc rgb '#606060' noenhanced front
set label 'h4' at screen 0.43914,0.70638 center font ',7' tc rgb '#606060' noenhanced front
set label 'h2' at screen 0.54705,0.73538 center font ',7' tc rgb '#606060' noenhanced front
set label 'h3' at screen 0.06456,0.48615 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00617; set rmargin at screen 0.99383
set bmargin at screen 0.02553; set tmargin at screen 0.94384
set xrange [-0.163247925:2.86324793]; set yrange [-0.151324793:3.25132479]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 1 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
