# Bernstein polynomials of degrees 1 to 4
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' basis.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,184 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,4.88cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'basis.'.format
data = 'basis.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 49 mm
set style textbox opaque noborder margins 0.6,0.6

# degree 1
set label 'degree 1' at screen 0.17026,0.94256 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.17026,0.04513 center font ',7' tc rgb '#202020' noenhanced front
set label '' at screen 0.01149,0.53590 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.06897; set rmargin at screen 0.27155
set bmargin at screen 0.17436; set tmargin at screen 0.89744
unset logscale x
set xrange [0:1]
set xtics ('0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [0:1]
set ytics ('0.0' 0, '0.5' 0.5, '1.0' 1)
set border 3; set tics scale 0.4,0.2
plot \
  data index 0 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 1 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00'
unset label; unset arrow

# degree 2
set label 'degree 2' at screen 0.40733,0.94256 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.40733,0.04513 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.30603; set rmargin at screen 0.50862
set bmargin at screen 0.17436; set tmargin at screen 0.89744
unset logscale x
set xrange [0:1]
set xtics ('0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [0:1]
set ytics ('' 0, '' 0.5, '' 1)
set border 3; set tics scale 0.4,0.2
plot \
  data index 2 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 3 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 4 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000'
unset label; unset arrow

# degree 3
set label 'degree 3' at screen 0.64440,0.94256 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.64440,0.04513 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.54310; set rmargin at screen 0.74569
set bmargin at screen 0.17436; set tmargin at screen 0.89744
unset logscale x
set xrange [0:1]
set xtics ('0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [0:1]
set ytics ('' 0, '' 0.5, '' 1)
set border 3; set tics scale 0.4,0.2
plot \
  data index 5 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 6 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 7 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 8 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00'
unset label; unset arrow

# degree 4
set label 'degree 4' at screen 0.88147,0.94256 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.88147,0.04513 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.78017; set rmargin at screen 0.98276
set bmargin at screen 0.17436; set tmargin at screen 0.89744
unset logscale x
set xrange [0:1]
set xtics ('0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [0:1]
set ytics ('' 0, '' 0.5, '' 1)
set border 3; set tics scale 0.4,0.2
plot \
  data index 9 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 10 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 11 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 12 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 13 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000'
unset label; unset arrow
unset multiplot
unset output
