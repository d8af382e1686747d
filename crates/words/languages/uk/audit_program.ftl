# Why a program is not held against its plan.
audit-program-not-run = програму не порівняно з планом: програма з помилкою в тексті не виконується; спершу виправте її
audit-program-no-route = програму не порівняно з планом: у плані немає маршруту (`route`)
audit-program-row-hole = програму не порівняно з планом: рядок { $row } не називає групи отворів (`hole`)
audit-program-row-tool = програму не порівняно з планом: рядок { $row } ({ $operation }) не називає інструмента (`tool`); якщо перехід на іншому верстаті, напишіть `elsewhere: true`
audit-program-row-diameter = програму не порівняно з планом: рядок { $row } ({ $operation }) не має діаметра (`diameter`)
audit-program-row-depth = програму не порівняно з планом: рядок { $row } ({ $operation }) не має глибини (`depth`)
audit-program-row-thread = програму не порівняно з планом: рядок { $row } нарізає різь в отворі, який її на кресленні не має
audit-program-row-mill = програму не порівняно з планом: рядок { $row } ({ $operation }) не каже, від якого діаметра (`from`) і якою фрезою
audit-program-row-conditions = програму не порівняно з планом: рядок { $row } ({ $operation }) не має режимів (`rpm` і `feed` чи `minute_feed`)
audit-setting-correction = налагодження: H{ $corrector } = { $value }, а за планом корекція T{ $tool } дорівнює { $needed }
