# What the conversion from powers to the Bernstein basis loses, against the degree
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' errors.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,252 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,6.66cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'errors.'.format
data = 'errors.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 67 mm

# 
set label 'degree' at screen 0.55975,0.14858 center font ',7' tc rgb '#202020' noenhanced front
set label 'relative error' at screen 0.02381,0.61031 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.15521,0.08104 to screen 0.23259,0.08104 nohead lc rgb '#0072B2' dt 1 lw 1
set label '' at screen 0.19390,0.08104 point pt 7 ps 0.45 lc rgb '#0072B2'
set label 'float' at screen 0.25045,0.08104 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.52672,0.08104 to screen 0.60410,0.08104 nohead lc rgb '#D55E00' dt 1 lw 1
set label '' at screen 0.56541,0.08104 point pt 5 ps 0.45 lc rgb '#D55E00'
set label 'double' at screen 0.62195,0.08104 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.15521,0.02701 to screen 0.23259,0.02701 nohead lc rgb '#009E73' dt 1 lw 1
set label '' at screen 0.19390,0.02701 point pt 9 ps 0.45 lc rgb '#009E73'
set label 'interval' at screen 0.25045,0.02701 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.52672,0.02701 to screen 0.60410,0.02701 nohead lc rgb '#E69F00' dt 1 lw 1
set label '' at screen 0.56541,0.02701 point pt 13 ps 0.45 lc rgb '#E69F00'
set label 'mpfr, 113 bits' at screen 0.62195,0.02701 left font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.15521; set rmargin at screen 0.96429
set bmargin at screen 0.24312; set tmargin at screen 0.97749
unset logscale x
set xrange [1.1600000000000001:30.84]
set xtics ('5' 5, '10' 10, '15' 15, '20' 20, '25' 25, '30' 30)
set logscale y
set yrange [6.501666666666667e-18:522480]
set ytics ('10⁻¹⁶' 1e-16, '10⁻¹³' 1e-13, '10⁻¹⁰' 1e-10, '10⁻⁷' 1e-07, '10⁻⁴' 0.0001, '10⁻¹' 0.1, '10²' 100, '10⁵' 100000, '0' 6.50167e-18)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 0 using 1:3:(0):($4-$3) with vectors nohead lw 0.6 lc rgb '#0072B2', \
  data index 1 using 1:3:(0):($4-$3) with vectors nohead lw 0.6 lc rgb '#D55E00', \
  data index 2 using 1:3:(0):($4-$3) with vectors nohead lw 0.6 lc rgb '#009E73', \
  data index 3 using 1:3:(0):($4-$3) with vectors nohead lw 0.6 lc rgb '#E69F00', \
  data index 0 using 1:2 with linespoints pt 7 ps 0.45 lc rgb '#0072B2' dt 1 lw 1, \
  data index 1 using 1:2 with linespoints pt 5 ps 0.45 lc rgb '#D55E00' dt 1 lw 1, \
  data index 2 using 1:2 with linespoints pt 9 ps 0.45 lc rgb '#009E73' dt 1 lw 1, \
  data index 3 using 1:2 with linespoints pt 13 ps 0.45 lc rgb '#E69F00' dt 1 lw 1
unset label; unset arrow
unset multiplot
unset output
