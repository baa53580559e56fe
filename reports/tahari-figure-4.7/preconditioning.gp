# A linear and a nonlinear system before and after preconditioning
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' preconditioning.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,164 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,4.35cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'preconditioning.'.format
data = 'preconditioning.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 44 mm
set style textbox opaque noborder margins 0.6,0.6

# linear, f
set label 'linear, f' at screen 0.15517,0.93563 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.15517,0.05057 center font ',7' tc rgb '#202020' noenhanced front
set label 'y' at screen 0.01149,0.54023 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.06897; set rmargin at screen 0.24138
set bmargin at screen 0.19540; set tmargin at screen 0.88506
unset logscale x
set xrange [-1:1]
set xtics ('−1.0' -1, '−0.5' -0.5, '0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [-1:1]
set ytics ('−1.0' -1, '−0.5' -0.5, '0.0' 0, '0.5' 0.5, '1.0' 1)
set border 3; set tics scale 0.4,0.2
plot \
  data index 0 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 1 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00'
unset label; unset arrow

# linear, M f
set label 'linear, M f' at screen 0.40230,0.93563 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.40230,0.05057 center font ',7' tc rgb '#202020' noenhanced front
set label 'y' at screen 0.26149,0.54023 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.31609; set rmargin at screen 0.48851
set bmargin at screen 0.19540; set tmargin at screen 0.88506
unset logscale x
set xrange [-1:1]
set xtics ('−1.0' -1, '−0.5' -0.5, '0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [-1:1]
set ytics ('−1.0' -1, '−0.5' -0.5, '0.0' 0, '0.5' 0.5, '1.0' 1)
set border 3; set tics scale 0.4,0.2
plot \
  data index 2 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 2 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 3 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 4 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 5 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# nonlinear, f
set label 'nonlinear, f' at screen 0.64943,0.93563 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.64943,0.05057 center font ',7' tc rgb '#202020' noenhanced front
set label 'y' at screen 0.50862,0.54023 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.56322; set rmargin at screen 0.73563
set bmargin at screen 0.19540; set tmargin at screen 0.88506
unset logscale x
set xrange [0.5:1.5]
set xtics ('0.5' 0.5, '1.0' 1, '1.5' 1.5)
unset logscale y
set yrange [0.5:1.5]
set ytics ('0.5' 0.5, '1.0' 1, '1.5' 1.5)
set border 3; set tics scale 0.4,0.2
plot \
  data index 6 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 7 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00'
unset label; unset arrow

# nonlinear, M f
set label 'nonlinear, M f' at screen 0.89655,0.93563 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.89655,0.05057 center font ',7' tc rgb '#202020' noenhanced front
set label 'y' at screen 0.75575,0.54023 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.81034; set rmargin at screen 0.98276
set bmargin at screen 0.19540; set tmargin at screen 0.88506
unset logscale x
set xrange [0.5:1.5]
set xtics ('0.5' 0.5, '1.0' 1, '1.5' 1.5)
unset logscale y
set yrange [0.5:1.5]
set ytics ('0.5' 0.5, '1.0' 1, '1.5' 1.5)
set border 3; set tics scale 0.4,0.2
plot \
  data index 8 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 8 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 9 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 10 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00'
unset label; unset arrow
unset multiplot
unset output
