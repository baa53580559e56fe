# Each instruction leaves the choice between two places; dashed lines lead to where its spheres do not meet
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-4.2.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,244 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,6.45cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-4.2.'.format
data = 'figure-4.2.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 64 mm
set style textbox opaque noborder margins 0.6,0.6

# branch (1, 1, 2)
set label 'branch (1, 1, 2)' at screen 0.50000,0.95659 center font ',8' tc rgb '#202020' noenhanced front
set label '' at screen 0.50000,-0.08217 center font ',7' tc rgb '#202020' noenhanced front
set label '' at screen 0.02381,0.46899 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.03571; set rmargin at screen 0.96429
set bmargin at screen 0.01550; set tmargin at screen 0.92248
unset logscale x
set xrange [-0.02:1.02]
set xtics ('' 0, '' 0.5, '' 1)
unset logscale y
set yrange [-3.35:0.3]
set ytics ('' -3, '' -2, '' -1, '' 0)
set border 0; set tics scale 0
plot \
  data index 0 using 1:2 with lines lw 0.5 dt 2 lc rgb '#808080', \
  data index 1 using 1:2 with lines lw 0.5 dt 2 lc rgb '#808080', \
  data index 2 using 1:2 with lines lw 0.5 dt 2 lc rgb '#808080', \
  data index 3 using 1:2 with lines lw 0.5 dt 2 lc rgb '#808080', \
  data index 4 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 5 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 6 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 7 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 8 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 9 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 10 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 11 using 1:2 with lines lw 2.4 dt 1 lc rgb '#000000', \
  data index 12 using 1:2 with lines lw 2.4 dt 1 lc rgb '#000000', \
  data index 13 using 1:2 with lines lw 2.4 dt 1 lc rgb '#000000', \
  data index 14 using 1:2:3 with labels center boxed noenhanced tc rgb '#000000', \
  data index 15 using 1:2:3 with labels center boxed noenhanced tc rgb '#000000', \
  data index 16 using 1:2:3 with labels center boxed noenhanced tc rgb '#000000', \
  data index 17 using 1:2:3 with labels center boxed noenhanced tc rgb '#000000', \
  data index 18 using 1:2:3 with labels center boxed noenhanced tc rgb '#000000', \
  data index 19 using 1:2:3 with labels center boxed noenhanced tc rgb '#808080', \
  data index 20 using 1:2:3 with labels center boxed noenhanced tc rgb '#808080', \
  data index 21 using 1:2:3 with labels center boxed noenhanced tc rgb '#000000', \
  data index 22 using 1:2:3 with labels center boxed noenhanced tc rgb '#000000', \
  data index 23 using 1:2:3 with labels center boxed noenhanced tc rgb '#808080', \
  data index 24 using 1:2:3 with labels center boxed noenhanced tc rgb '#808080', \
  data index 25 using 1:2:3 with labels center boxed noenhanced tc rgb '#000000', \
  data index 26 using 1:2:3 with labels center boxed noenhanced tc rgb '#000000', \
  data index 27 using 1:2:3 with labels center boxed noenhanced tc rgb '#000000'
unset label; unset arrow
unset multiplot
unset output
