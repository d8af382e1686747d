# The norm of time.
norm-heading = Norm of time
norm-not-whole = A part that is not made whole has no norm of time.
norm-piece = Tpiece = (Tb + Ta)·(1 + (service + rest)/100) = ({ $basic } + { $auxiliary })·(1 + ({ $service } + { $rest })/100) = { $piece } min.
norm-no-loading = How long this part takes to load no table says: `loading` in the title block gives it. Until then there is no time per piece.
norm-gauging-meanwhile = Gauging goes on while the machine makes the next part: of this time only what is longer than the program counts.
norm-preparatory-is = Tset = { $preparatory } min for a lot.
norm-with-lot = For a lot of { $lot } with its share of the preparation: Tpiece + Tset/n = { $piece } + { $preparatory }/{ $lot } = { $with } min.
norm-no-lot = How many parts a lot has is not given (`lot` in the title block), so Tset is not shared among them.
norm-indicating = The axis of each part is found with an indicator: no table at hand has a time for it, so it is not in the norm.
norm-unconfirmed = Times marked * rest on figures that no source confirms for such a machine; a norm of the shop goes before them.
norm-element = Element
norm-each = Each
norm-total = Together
norm-source = From
norm-basic = cutting, Tb
norm-machine = rapids, tool changes, dwells
norm-hands = hands while the program waits
norm-of-plan = plan
norm-given = title block
norm-loading = loading, clamping and unloading
norm-regrip = the jaws are set to another force at a stop
norm-more-clamps = each clamp beyond three
norm-plug-coarse = hole or slot of grade 11 and coarser, with a plug
norm-plug-fine = hole or slot of a finer grade, with a plug
norm-thread-plug = thread, with a plug
norm-gauging-beyond = gauging that is longer than the program
norm-service = looking after the place of work
norm-rest = rest and needs
norm-share = { $what }: { $share } % of Tb + Ta
norm-receive-order = order, papers, program and tools are received and handed in
norm-study-order = papers are read, blanks looked at
norm-instruction = instruction by the foreman
norm-set-up = the machine is set, with the first three tools
norm-tool = each further tool is put in and taken out
norm-soft-jaws = soft jaws are put on and bored
norm-zeros = the zero of a set-up
norm-trial = trial run of the program
norm-preparatory = preparation of the lot, in all
time-norm = norm of time
