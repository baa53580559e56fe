# Grey: simplices inside of the domain of the old branch; red: those with a vertex (disc) outside of it, where the border (dashed) is taken for a line; blue: on the new branch, the first one the mirror image of the last red one. Black and blue lines: the path on both branches; dashed blue: what the simplices follow
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-4.10.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,312 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,8.25cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-4.10.'.format
data = 'figure-4.10.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 82 mm
set style textbox opaque noborder margins 0.6,0.6

# 
set label '' at screen 0.55357,0.96606 center font ',8' tc rgb '#202020' noenhanced front
set label 'k0 = distance P3 P0' at screen 0.55357,0.02667 center font ',7' tc rgb '#202020' noenhanced front
set label 't' at screen 0.02381,0.52121 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.14286; set rmargin at screen 0.96429
set bmargin at screen 0.10303; set tmargin at screen 0.93939
unset logscale x
set xrange [2.253284945334029:2.305484091972399]
set xtics ('2.26' 2.26, '2.28' 2.28, '2.30' 2.3)
unset logscale y
set yrange [1.7345909111094078:1.8546975908230798]
set ytics ('1.75' 1.75, '1.80' 1.8, '1.85' 1.85)
set border 3; set tics scale 0.4,0.2
plot \
  data index 0 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 0 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 1 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 1 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 2 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 2 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 3 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 3 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 4 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 4 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 5 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 5 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 6 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 6 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 7 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 7 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 8 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 8 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 9 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 9 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 10 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 10 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 11 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 11 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 12 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 12 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 13 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 13 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 14 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 14 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 15 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 15 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 16 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 16 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 17 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 17 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 18 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 18 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 19 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 19 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 20 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 20 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 21 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 21 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 22 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 22 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 23 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#F7DCC8', \
  data index 23 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 24 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E8F1F8', \
  data index 24 using 1:2 with lines lw 0.1 dt 1 lc rgb '#0072B2', \
  data index 25 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E8F1F8', \
  data index 25 using 1:2 with lines lw 0.1 dt 1 lc rgb '#0072B2', \
  data index 26 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E8F1F8', \
  data index 26 using 1:2 with lines lw 0.1 dt 1 lc rgb '#0072B2', \
  data index 27 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E8F1F8', \
  data index 27 using 1:2 with lines lw 0.1 dt 1 lc rgb '#0072B2', \
  data index 28 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 29 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 30 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 31 using 1:2 with lines lw 0.5 dt 2 lc rgb '#0072B2', \
  data index 32 using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00'
unset label; unset arrow
unset multiplot
unset output
