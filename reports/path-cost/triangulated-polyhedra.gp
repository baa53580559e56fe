# Triangulated polyhedra: median time of a step
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' triangulated-polyhedra.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,246 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,6.51cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'triangulated-polyhedra.'.format
data = 'triangulated-polyhedra.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 65 mm

# 
set label 'unknowns' at screen 0.54299,0.09683 center font ',7' tc rgb '#202020' noenhanced front
set label 'time of a step [µs]' at screen 0.02381,0.58531 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.12170,0.02767 to screen 0.19908,0.02767 nohead lc rgb '#0072B2' dt 1 lw 1
set label '' at screen 0.16039,0.02767 point pt 7 ps 0.45 lc rgb '#0072B2'
set label 'dense' at screen 0.21694,0.02767 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.35915,0.02767 to screen 0.43653,0.02767 nohead lc rgb '#D55E00' dt 1 lw 1
set label '' at screen 0.39784,0.02767 point pt 5 ps 0.45 lc rgb '#D55E00'
set label 'sparse' at screen 0.45438,0.02767 left font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.12170; set rmargin at screen 0.96429
set bmargin at screen 0.19367; set tmargin at screen 0.97694
set logscale x
set xrange [5:360]
set xtics ('10' 10, '100' 100)
set logscale y
set yrange [0.8516666666666667:612.1392000000001]
set ytics ('1' 1, '10' 10, '100' 100)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 0 using 1:3:(0):($4-$3) with vectors nohead lw 0.6 lc rgb '#0072B2', \
  data index 1 using 1:3:(0):($4-$3) with vectors nohead lw 0.6 lc rgb '#D55E00', \
  data index 0 using 1:2 with linespoints pt 7 ps 0.45 lc rgb '#0072B2' dt 1 lw 1, \
  data index 1 using 1:2 with linespoints pt 5 ps 0.45 lc rgb '#D55E00' dt 1 lw 1, \
  data index 2 using 1:2 with lines lw 1 lc rgb '#0072B2' dt 2, \
  data index 3 using 1:2 with lines lw 1 lc rgb '#D55E00' dt 2
unset label; unset arrow
unset multiplot
unset output
