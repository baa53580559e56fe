# The lengths of table 3.1 at the edges of one of the figures
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' lengths.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 306,311 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.10cm,8.22cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'lengths.'.format
data = 'lengths.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 81 mm x 82 mm
set label 'octahedron' at screen 0.50000,0.96349 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1, 1 solution
set label '1 solution' at screen 0.50000,0.05233 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.89834,0.09883 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.55268,0.72018 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.02946,0.14104 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.11895,0.90847 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.52365,0.31470 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.96497,0.90162 center font ',7' tc rgb '#202020' noenhanced front
set label 'h3 = 1.06129' at screen 0.66031,0.16871 center font ',7' tc rgb '#606060' noenhanced front
set label 'h6 = 1.00796' at screen 0.71446,0.84371 center font ',7' tc rgb '#606060' noenhanced front
set label 'h5 = 1.18592' at screen 0.37339,0.84756 center font ',7' tc rgb '#606060' noenhanced front
set label 'h8 = 1.17417' at screen 0.31746,0.19542 center font ',7' tc rgb '#606060' noenhanced front
set label 'h0 = 1.11983' at screen 0.79101,0.47970 center font ',7' tc rgb '#606060' noenhanced front
set label 'h9 = 1.07569' at screen 0.40764,0.69083 center font ',7' tc rgb '#606060' noenhanced front
set label 'h10 = 1.19071' at screen 0.82157,0.89886 center font ',7' tc rgb '#606060' noenhanced front
set label 'h2 = 1.18117' at screen 0.23054,0.48854 center font ',7' tc rgb '#606060' noenhanced front
set label 'h7 = 1.15857' at screen 0.21817,0.53389 center font ',7' tc rgb '#606060' noenhanced front
set label 'h4 = 1.12482' at screen 0.79322,0.51000 center font ',7' tc rgb '#606060' noenhanced front
set label 'h11 = 1.16643' at screen 0.54216,0.90311 center font ',7' tc rgb '#606060' noenhanced front
set label 'h1 = 1.17389' at screen 0.46554,0.11476 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00617; set rmargin at screen 0.99383
set bmargin at screen 0.07423; set tmargin at screen 0.93307
set xrange [-1.24888465:0.172565791]; set yrange [-0.0710725218:1.18297837]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 1 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 2 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 3 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 4 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 5 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 6 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 7 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 8 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 9 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 10 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
