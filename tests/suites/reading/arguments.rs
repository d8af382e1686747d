//! Arguments that name what is not there: which there are stands in the message.

use std::fs;

use technolog_testing::root;

use super::{command, folder};

#[test]
fn what_is_not_there_is_told_with_what_is() {
    let folder = folder("arguments");
    for (name, file) in [("plate.yaml", "examples/plate.yaml"), ("pin.yaml", "examples/turned-pin.yaml")] {
        fs::copy(root().join(file), folder.join(name)).unwrap();
    }
    let part = fs::read_to_string(root().join("examples/plate.yaml")).unwrap();
    fs::write(folder.join("foo.yaml"), part.replace("machine: gf2171", "machine: foo")).unwrap();
    fs::write(folder.join("points.csv"), "0,0\n1,1\n").unwrap();
    fs::write(folder.join("program.nc"), "%\n:01\nN1 M02\n").unwrap();
    for (arguments, told, help) in [
        (
            "order points.csv --machine foo",
            "[unknown-machine]: the catalog has no machine `foo`",
            "there are: gf2171, ir500pmf4",
        ),
        ("order points.csv --metric rapid --machine foo", "[unknown-machine]", "there are: gf2171"),
        ("check program.nc --machine foo", "[unknown-machine]", "there are: gf2171"),
        ("program foo.yaml", "--> foo.yaml:5:10", "gf2171, ir500pmf4"),
        ("order foo.yaml", "--> foo.yaml:5:10", "gf2171, ir500pmf4"),
        ("check program.nc --part foo.yaml", "--> foo.yaml:5:10", "gf2171, ir500pmf4"),
        ("explain plate.yaml --hole В", "[unknown-hole]", "the part file has `B`"),
        ("explain plate.yaml --hole zzz", "[unknown-hole]", "A, B"),
        ("table A.18", "[unknown-table]", "`A.18a`, `A.18b`"),
        ("turn pin.yaml --show program --number 9", "[no-such-program]", "help: give one of these with --number: 1: "),
    ] {
        let answer = command(&folder, &arguments.split(' ').collect::<Vec<_>>(), b"");
        assert_eq!((answer.code, answer.answer.as_str()), (Some(2), ""), "{arguments}: {}", answer.beside);
        assert!(answer.beside.contains(told) && answer.beside.contains(help), "{arguments}: {}", answer.beside);
    }
}
