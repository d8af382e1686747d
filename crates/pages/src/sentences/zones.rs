//! The words about main and additional elements, set-ups, zones and the tools for them.

pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    // What an element is.
    (
        "element-main",
        "{surface}: основний елемент: підйом {rise}° не крутіший за φ = {main}°, спад {fall}° не крутіший за φ1 = {secondary}°",
        "{surface}: a main element: it rises {rise}°, not steeper than φ = {main}°, and falls {fall}°, not steeper than \
         φ1 = {secondary}°",
    ),
    (
        "element-by-kind",
        "{surface}: додатковий елемент за видом поверхні; інструмент: {take}",
        "{surface}: an additional element by its kind; tool: {take}",
    ),
    (
        "element-rises",
        "{surface}: підйом {rise}° крутіший за φ = {main}°; інструмент: {take}",
        "{surface}: it rises {rise}°, steeper than φ = {main}°; tool: {take}",
    ),
    (
        "element-falls",
        "{surface}: спад {fall}° крутіший за φ1 = {secondary}°; інструмент: {take}",
        "{surface}: it falls {fall}°, steeper than φ1 = {secondary}°; tool: {take}",
    ),
    (
        "element-leads-back",
        "{surface}: веде назад до вільного торця або лежить під тим, що веде назад; інструмент: {take}",
        "{surface}: it leads back towards the free end, or lies under what does; tool: {take}",
    ),
    (
        "element-in-shadow",
        "{surface}: лежить за крутим спадом, куди різець із φ1 = {secondary}° не дістає; інструмент: {take}",
        "{surface}: it lies behind a steep fall, where a tool with φ1 = {secondary}° does not come; tool: {take}",
    ),
    (
        "element-in-corner",
        "{surface}: лежить перед крутим підйомом, куди різець із φ = {main}° не дістає; інструмент: {take}",
        "{surface}: it lies before a steep rise, where a tool with φ = {main}° does not come; tool: {take}",
    ),
    (
        "element-in-valley",
        "{surface}: стінка западини, до дна якої різець не дістає; інструмент: {take}",
        "{surface}: a wall of a valley whose floor the tool does not reach; tool: {take}",
    ),
    (
        "element-beyond",
        "{surface}: лежить за спадом, після якого контур уже не підіймається, тож її обробляють з іншого боку",
        "{surface}: it lies behind a fall after which the contour never rises again, so it is turned from the other end",
    ),
    (
        "element-partly",
        "{surface}: частину її різець обробив би, та додатковим є весь елемент",
        "{surface}: a part of it the tool would make, but the whole element is additional",
    ),
    // Set-ups.
    ("setup-first", "з вільного торця", "from the free end"),
    ("setup-only", "один установ обробляє все", "one set-up makes all of it"),
    (
        "setup-falls-away",
        "від Z {z}, Ø{diameter} контур спадає до патрона крутіше за φ1 = {secondary}° і вже не підіймається",
        "from Z {z}, Ø{diameter} the contour falls towards the chuck more steeply than φ1 = {secondary}° and never rises again",
    ),
    ("setup-bore-widens", "отвір розширюється до дальнього торця", "the bore widens towards the far face"),
    ("setup-far-face", "на дальньому торці є припуск", "there is stock on the far face"),
    ("hold-centres", "деталь у центрах", "the part is held between centres"),
    (
        "hold-blank",
        "заготовку тримають за Ø{diameter} на довжині {length} мм (потрібно щонайменше {least} мм)",
        "the blank is held by Ø{diameter} over {length} mm (at least {least} mm are needed)",
    ),
    (
        "hold-blank-short",
        "за Ø{diameter} заготовки лишається {length} мм, потрібно щонайменше {least} мм: візьміть довшу заготовку або центри",
        "only {length} mm of the blank's Ø{diameter} are left, at least {least} mm are needed: take a longer blank or centres",
    ),
    (
        "hold-surface",
        "деталь тримають за {surface}, Ø{diameter}, довжина {length} мм (потрібно щонайменше {least} мм): найтовщий з досить довгих циліндрів",
        "the part is held by {surface}, Ø{diameter}, {length} mm long (at least {least} mm are needed): the thickest of \
         the cylinders that are long enough",
    ),
    (
        "hold-surface-short",
        "{surface}: довжина {length} мм менша за {least} мм",
        "{surface}: {length} mm are less than {least} mm",
    ),
    (
        "hold-nowhere",
        "немає досить довгого обробленого циліндра: потрібні центри, оправка або розточені кулачки",
        "no turned cylinder is long enough: centres, a mandrel or bored jaws are needed",
    ),
    // Tools against zones.
    ("tool-main-angle", "φ = {has}° менший за {needs}°", "φ = {has}° is less than {needs}°"),
    ("tool-secondary-angle", "φ1 = {has}° менший за {needs}°", "φ1 = {has}° is less than {needs}°"),
    (
        "tool-bore-too-small",
        "отвір Ø{bore} менший за найменший для різця Ø{least}",
        "the bore of Ø{bore} is smaller than the least for the tool, Ø{least}",
    ),
    (
        "tool-wider-than-groove",
        "ширина різця {width} мм більша за дно {floor} мм",
        "the tool is {width} mm wide, the floor {floor} mm",
    ),
    (
        "tool-only-for-grooves",
        "канавковий різець лише для закритих зон, а ця {kind}",
        "a grooving tool is for closed zones, and this one is {kind}",
    ),
];

/// What the tools of elements are called.
pub(super) const TERMS: &[(&str, &str, &str)] = &[
    ("contouring", "різець для контурної обробки", "contouring tool"),
    ("other-main-angle", "контурний різець з більшим φ", "contouring tool with a larger φ"),
    ("other-secondary-angle", "контурний різець з більшим φ1", "contouring tool with a larger φ1"),
    ("other-hand", "контурний різець іншого напряму", "contouring tool of the other hand"),
    ("other-set-up", "з іншого установа", "from the other set-up"),
    ("grooving", "канавковий різець", "grooving tool"),
    ("relief-grooving", "кутовий канавковий різець", "tool for corner reliefs"),
    ("face-grooving", "торцевий канавковий різець", "face grooving tool"),
    ("threading", "різьовий різець", "threading tool"),
];
