# Bold: on the branch of the sketch (square). Black points: changes of branch. Discs: figures with the wanted lengths
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-4.8.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,286 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,7.56cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-4.8.'.format
data = 'figure-4.8.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 76 mm
set style textbox opaque noborder margins 0.6,0.6

# 
set label '' at screen 0.55357,0.96296 center font ',8' tc rgb '#202020' noenhanced front
set label 'k0 = distance P3 P0' at screen 0.55357,0.02910 center font ',7' tc rgb '#202020' noenhanced front
set label 't' at screen 0.02381,0.52315 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.14286; set rmargin at screen 0.96429
set bmargin at screen 0.11243; set tmargin at screen 0.93386
unset logscale x
set xrange [-0.06423895816207457:2.423982012826492]
set xtics ('0' 0, '1' 1, '2' 2)
unset logscale y
set yrange [-0.1294266919797949:2.2738300884027463]
set ytics ('0' 0, '1' 1, '2' 2)
set border 3; set tics scale 0.4,0.2
plot \
  data index 0 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 1 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 2 using 1:2 with lines lw 2.4 dt 1 lc rgb '#000000', \
  data index 3 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 4 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 5 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 6 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 7 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 8 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 9 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 10 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 11 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 12 using 1:2 with lines lw 2.4 dt 1 lc rgb '#000000', \
  data index 13 using 1:2 with points pt 7 ps 0.6 lc rgb '#000000', \
  data index 14 using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00', \
  data index 15 using 1:2 with points pt 5 ps 0.6 lc rgb '#000000'
unset label; unset arrow
unset multiplot
unset output
