# Simplices on a path as long as an edge: one guide on the octahedron, two to four on prisms of 3 to 5 sides
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' growth.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,254 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,6.71cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'growth.'.format
data = 'growth.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 67 mm

# 
set label 'guides' at screen 0.52624,0.09391 center font ',7' tc rgb '#202020' noenhanced front
set label 'simplices per edge' at screen 0.02381,0.58273 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.08819,0.02683 to screen 0.16557,0.02683 nohead lc rgb '#0072B2' dt 1 lw 1
set label '' at screen 0.12688,0.02683 point pt 7 ps 0.45 lc rgb '#0072B2'
set label 'edges 0.01' at screen 0.18342,0.02683 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.40942,0.02683 to screen 0.48680,0.02683 nohead lc rgb '#D55E00' dt 1 lw 1
set label '' at screen 0.44811,0.02683 point pt 5 ps 0.45 lc rgb '#D55E00'
set label 'edges 0.001' at screen 0.50465,0.02683 left font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.08819; set rmargin at screen 0.96429
set bmargin at screen 0.18782; set tmargin at screen 0.97764
unset logscale x
set xrange [0.5:4.5]
set xtics ('1' 1, '2' 2, '3' 3, '4' 4)
unset logscale y
set yrange [0:8]
set ytics ('0' 0, '2' 2, '4' 4, '6' 6, '8' 8)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 0 using 1:2 with linespoints pt 7 ps 0.45 lc rgb '#0072B2' dt 1 lw 1, \
  data index 1 using 1:2 with linespoints pt 5 ps 0.45 lc rgb '#D55E00' dt 1 lw 1
unset label; unset arrow
unset multiplot
unset output
