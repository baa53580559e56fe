# A graph of fifteen points in the plane and twenty-seven distances that no construction by intersecting loci decomposes
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-6.3.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 306,292 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.10cm,7.73cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-6.3.'.format
data = 'figure-6.3.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 81 mm x 77 mm
set label 'fifteen-points' at screen 0.50000,0.96117 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.50000,0.00906 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.34855,0.42298 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.56459,0.38431 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.41942,0.61159 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.46803,0.79483 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.30535,0.83380 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.78446,0.42193 center font ',7' tc rgb '#202020' noenhanced front
set label 'P6' at screen 0.94760,0.24374 center font ',7' tc rgb '#202020' noenhanced front
set label 'P7' at screen 0.10204,0.87974 center font ',7' tc rgb '#202020' noenhanced front
set label 'P8' at screen 0.87400,0.90263 center font ',7' tc rgb '#202020' noenhanced front
set label 'P9' at screen 0.72148,0.83727 center font ',7' tc rgb '#202020' noenhanced front
set label 'P10' at screen 0.54313,0.05217 center font ',7' tc rgb '#202020' noenhanced front
set label 'P11' at screen 0.04032,0.40158 center font ',7' tc rgb '#202020' noenhanced front
set label 'P12' at screen 0.64154,0.66182 center font ',7' tc rgb '#202020' noenhanced front
set label 'P13' at screen 0.66205,0.23182 center font ',7' tc rgb '#202020' noenhanced front
set label 'P14' at screen 0.22637,0.24075 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.00617; set rmargin at screen 0.99383
set bmargin at screen 0.03236; set tmargin at screen 0.92880
set xrange [-3.89642956:6.3867779]; set yrange [-3.78992627:5.11172654]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 1 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
