//! A file of another kind than a command takes gets one message: what it seems to be, and which command is right for it.

use technolog_testing::root;

use super::command;

#[test]
fn a_file_of_another_kind_is_told_once_with_its_command() {
    for (arguments, message, help) in [
        ("plan shaft.yaml", "this is a file of a turned part", "`technolog turn shaft.yaml`"),
        ("program turned-pin.yaml", "this is a file of a turned part", "`technolog turn turned-pin.yaml`"),
        ("plan appendix-g/plan.yaml", "this is a plan", "`technolog audit appendix-g/plan.yaml`"),
        ("plan appendix-g/program.nc", "this is an NC program", "`technolog check appendix-g/program.nc`"),
        ("plan appendix-g/setting.yaml", "this is a setting file", "--setting appendix-g/setting.yaml`"),
        ("explain marks.yaml --hole A", "this is a marking scheme", "--marks marks.yaml`"),
        ("order cases/plate.test.yaml", "this is a file of cases", "`technolog test cases/plate.test.yaml`"),
        ("order appendix-g/program.nc", "a list of points is needed here", "`technolog check"),
        ("plan ../catalogs/controls/program-conventions.yaml", "this is a table", "`technolog lint"),
        ("turn plate.yaml", "this is a file of a part with holes", "`technolog plan plate.yaml`"),
        ("audit plate.yaml", "but a plan is needed here", "`technolog plan plate.yaml`"),
        ("test plate.yaml", "but a file of cases is needed here", "`technolog plan plate.yaml`"),
        ("check plate.yaml", "but an NC program is needed here", "`technolog plan plate.yaml`"),
        ("check ../docs/part.schema.json", "this is a YAML or JSON file", "`technolog --help`"),
        ("check appendix-g/program.nc --setting plate.yaml", "a setting file is needed here", "technolog plan"),
        ("check appendix-g/program.nc --part shaft.yaml", "this is a file of a turned part", "technolog turn"),
        (
            "check appendix-g/program.nc --part shaft.yaml",
            "this is a file of a turned part",
            "--control linuxcnc-lathe",
        ),
        ("audit appendix-g/plan.yaml --marks plate.yaml", "a marking scheme is needed here", "technolog plan"),
    ] {
        let arguments: Vec<&str> = arguments.split(' ').collect();
        let answer = command(&root().join("examples"), &arguments, b"");
        let output = answer.answer + &answer.beside;
        assert_eq!((answer.code, output.matches("error[").count()), (Some(2), 1), "{arguments:?}: {output}");
        assert!(output.contains("error[other-kind]") && output.contains(message) && output.contains(help), "{output}");
    }
}
