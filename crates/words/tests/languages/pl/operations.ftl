operation-drill = wiercenie
    .verb = Wiercić
