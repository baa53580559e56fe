# Guide and t: the border of the domain (dashed), the path before (bold) and after B, and the mirror image of the latter (dashed blue), which the simplices follow. The others: the three spheres of the instruction, cut by a plane through both places of its point, at A, B and C
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-4.9.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,295 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,7.80cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-4.9.'.format
data = 'figure-4.9.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 78 mm
set style textbox opaque noborder margins 0.6,0.6

# guide and t
set label 'guide and t' at screen 0.30952,0.96409 center font ',8' tc rgb '#202020' noenhanced front
set label 'k0 = distance P3 P0' at screen 0.30952,0.49597 center font ',7' tc rgb '#202020' noenhanced front
set label 't' at screen 0.02381,0.75632 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.14286; set rmargin at screen 0.47619
set bmargin at screen 0.57677; set tmargin at screen 0.93587
unset logscale x
set xrange [2.0524351259439046:2.380307680179297]
set xtics ('2.1' 2.1, '2.2' 2.2, '2.3' 2.3)
unset logscale y
set yrange [1.7779536331140429:2.106162054962584]
set ytics ('1.8' 1.8, '1.9' 1.9, '2.0' 2, '2.1' 2.1)
set border 3; set tics scale 0.4,0.2
plot \
  data index 0 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 1 using 1:2 with lines lw 2.4 dt 1 lc rgb '#000000', \
  data index 2 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 3 using 1:2 with lines lw 0.5 dt 2 lc rgb '#0072B2', \
  data index 4 using 1:2 with points pt 7 ps 0.6 lc rgb '#000000', \
  data index 5 using 1:2:3 with labels left offset character 0.5,0.5 noenhanced tc rgb '#000000', \
  data index 6 using 1:2:3 with labels left offset character 0.5,0.5 noenhanced tc rgb '#000000', \
  data index 7 using 1:2:3 with labels left offset character 0.5,0.5 noenhanced tc rgb '#000000'
unset label; unset arrow

# (a) at A
set label '(a) at A' at screen 0.79762,0.87797 center font ',8' tc rgb '#202020' noenhanced front
set label '' at screen 0.79762,0.49597 center font ',7' tc rgb '#202020' noenhanced front
set label '' at screen 0.51786,0.71326 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.63095; set rmargin at screen 0.96429
set bmargin at screen 0.57677; set tmargin at screen 0.84976
unset logscale x
set xrange [-3.4940592283681315:1.5609908058664774]
set xtics ('' -2, '' 0)
unset logscale y
set yrange [-1.9214112087826078:1.9214112087826078]
set ytics ('' -1, '' 0, '' 1)
set border 0; set tics scale 0
plot \
  data index 8 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 9 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 10 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 11 using 1:2 with lines lw 0.5 dt 2 lc rgb '#808080', \
  data index 12 using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00', \
  data index 13 using 1:2:3 with labels left offset character 0.5,0.5 noenhanced tc rgb '#D55E00'
unset label; unset arrow

# (b) at B
set label '(b) at B' at screen 0.30952,0.43184 center font ',8' tc rgb '#202020' noenhanced front
set label '' at screen 0.30952,0.02822 center font ',7' tc rgb '#202020' noenhanced front
set label '' at screen 0.02381,0.25632 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.14286; set rmargin at screen 0.47619
set bmargin at screen 0.10901; set tmargin at screen 0.40363
unset logscale x
set xrange [-3.5497426951797313:1.0310854502833604]
set xtics ('' -2, '' 0)
unset logscale y
set yrange [-1.8790576034782327:1.8790576034782327]
set ytics ('' -1, '' 0, '' 1)
set border 0; set tics scale 0
plot \
  data index 14 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 15 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 16 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 17 using 1:2 with lines lw 0.5 dt 2 lc rgb '#808080', \
  data index 18 using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00', \
  data index 19 using 1:2:3 with labels left offset character 0.5,0.5 noenhanced tc rgb '#D55E00'
unset label; unset arrow

# (c) at C
set label '(c) at C' at screen 0.79762,0.41671 center font ',8' tc rgb '#202020' noenhanced front
set label '' at screen 0.79762,0.02822 center font ',7' tc rgb '#202020' noenhanced front
set label '' at screen 0.51786,0.24875 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.63095; set rmargin at screen 0.96429
set bmargin at screen 0.10901; set tmargin at screen 0.38849
unset logscale x
set xrange [-3.5111807350677795:1.5138198406868852]
set xtics ('' -2, '' 0)
unset logscale y
set yrange [-1.955378257780073:1.955378257780073]
set ytics ('' -1, '' 0, '' 1)
set border 0; set tics scale 0
plot \
  data index 20 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 21 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 22 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 23 using 1:2 with lines lw 0.5 dt 2 lc rgb '#808080', \
  data index 24 using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00', \
  data index 25 using 1:2:3 with labels left offset character 0.5,0.5 noenhanced tc rgb '#D55E00'
unset label; unset arrow
unset multiplot
unset output
