# What was published, in gnuplot's words; figures draw it beside runs.

# Stoop et al., PRL 106, 214102 (2011): densest packings of the high torsion setup follow
# (a/R)^alpha with alpha = 0.38 +- 0.04, up to 0.58 at the largest a/R, 0.25. The factor follows.
paper_exponent = 0.38
paper_phi_max(x) = 0.58 * (x / 0.25)**paper_exponent

# The same as a law of mass against R, M ~ R^(3 - alpha): 2.62 +- 0.04.
paper_mass_exponent = 3 - paper_exponent
# Aguiar et al. 1991, crumpled wires.
aguiar_mass_exponent = 2.75

# The same: bending energies of segments over their mean are log-normal (a/R = 1/40, high torsion).
paper_log_mean = -0.903
paper_log_deviation = 1.275
# per unit of ln x
paper_bend_distribution(x) = exp(-((log(x) - paper_log_mean) / paper_log_deviation)**2 / 2) \
    / (sqrt(2 * pi) * paper_log_deviation)

# DNA in the heads of phages, as a wire of a = 1 nm and 0.34 nm per base pair: a/R, phi.
$phages << EOD
# lambda: 48.5 kbp, R = 29 nm (BioNumbers 103121 to 103123)
0.0345 0.507
# phi29: 19.3 kbp in a sphere of the volume of its head, R = 22.03 nm (Purohit et al. 2003)
0.0454 0.461
# T7: 39.9 kbp, outer diameter 58 nm, a lower bound (BioNumbers 109733)
0.0345 0.418
EOD

# Endovascular coils: clinical mean packing of aneurysms (Vallee et al. 2004; Radiology 2007).
coils_lowest = 0.20
coils_highest = 0.31
