# The same, one unknown against t
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-3.4.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,282 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,7.46cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-3.4.'.format
data = 'figure-3.4.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 75 mm
set label 'P3_y' at screen 0.56548,0.19450 center font ',7' tc rgb '#202020' noenhanced front
set label 't' at screen 0.02381,0.62609 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.15476,0.13414 to screen 0.26190,0.13414 nohead lc rgb '#0072B2' dt 1 lw 1.1
set label 'a cycle' at screen 0.27976,0.13414 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.15476,0.08585 to screen 0.26190,0.08585 nohead lc rgb '#D55E00' dt 2 lw 1.1
set label 'to infinity' at screen 0.27976,0.08585 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.15476,0.03756 to screen 0.26190,0.03756 nohead lc rgb '#009E73' dt 3 lw 1.1
set label 'to an undefined point' at screen 0.27976,0.03756 left font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.15476; set rmargin at screen 0.97619
set bmargin at screen 0.27901; set tmargin at screen 0.97317
unset logscale x
set xrange [0:6]
set xtics ('0' 0, '2' 2, '4' 4, '6' 6)
unset logscale y
set yrange [-0.32238156:1.075929]
set ytics ('0.0' 0, '0.5' 0.5, '1.0' 1)
set border 3; plot data index 0 using 1:2 with lines lw 0.6 lc rgb '#A0A0A0', \
  data index 1 using 1:2 with lines lw 0.6 lc rgb '#A0A0A0', \
  data index 2 using 1:2 with lines lc rgb '#0072B2' dt 1 lw 1.1, \
  data index 3 using 1:2 with lines lc rgb '#D55E00' dt 2 lw 1.1, \
  data index 4 using 1:2 with lines lc rgb '#009E73' dt 3 lw 1.1, \
  data index 5 using 1:2 with points pt 5 ps 0.6 lc rgb '#202020', \
  data index 6 using 1:2 with points pt 7 ps 0.6 lc rgb '#202020'
unset label; unset arrow
unset multiplot
unset output
