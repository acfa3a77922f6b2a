# gnuplot data/figures/friction.gp, in the root of the repository: draws data/figures/friction.png
set terminal pngcairo size 1500,520 font "Sans,13"
set output "data/figures/friction.png"
set datafile separator ","
set multiplot layout 1,3
set xlabel "packing density"
set key top left
rows = "< awk -F, '$1 == \"%s\" && $2 == \"%s\" && $5 > 0 { if (seed != $3 && seed) print \"\"; "
columns = "seed = $3; print $4 \",\" $5 \",\" $9 \",\" $8 }' data/figures/friction.csv"
curve(setup, mu) = sprintf(rows . columns, setup, mu)
set yrange [0:1]
set ylabel "order of coil axes"
set key bottom left
plot curve("low", "0") using 1:2 with lines dt 3 lw 2 lc "#1f77b4" \
       title "low torsion, no friction", \
     curve("low", "0.2") using 1:2 with lines lw 2 lc "#1f77b4" title "low torsion, 0.2", \
     curve("high", "0") using 1:2 with lines dt 3 lw 2 lc "#d62728" \
       title "high torsion, no friction", \
     curve("high", "0.2") using 1:2 with lines lw 2 lc "#d62728" title "high torsion, 0.2"
set yrange [0:*]
set ylabel "torsional energy [YI/R]"
unset key
plot curve("low", "0") using 1:3 with lines dt 3 lw 2 lc "#1f77b4", \
     curve("low", "0.2") using 1:3 with lines lw 2 lc "#1f77b4", \
     curve("high", "0") using 1:3 with lines dt 3 lw 2 lc "#d62728", \
     curve("high", "0.2") using 1:3 with lines lw 2 lc "#d62728"
set ylabel "bending energy [YI/R]"
plot curve("low", "0") using 1:4 with lines dt 3 lw 2 lc "#1f77b4", \
     curve("low", "0.2") using 1:4 with lines lw 2 lc "#1f77b4", \
     curve("high", "0") using 1:4 with lines dt 3 lw 2 lc "#d62728", \
     curve("high", "0.2") using 1:4 with lines lw 2 lc "#d62728"
