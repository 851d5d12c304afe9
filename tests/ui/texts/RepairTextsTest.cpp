// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/RepairTexts.h"

#include "tests/support/program/MarkingTranslator.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <glm/gtc/matrix_transform.hpp>

#include <vector>

namespace repairTextsTest {

using core::RepairOffer;

namespace {

struct Worded {
    RepairOffer offer;
    const char* title;
    const char* effect;
};

core::VolumeGeometry grid()
{
    core::VolumeGeometry geometry;
    geometry.size = {4, 5, 6};
    geometry.indexToWorld = glm::scale(glm::dmat4(1.0), glm::dvec3(0.5, 0.75, 2.5));
    return geometry;
}

RepairOffer tilt(int columns, int rows)
{
    return {
        .kind = RepairOffer::Kind::ShearTilt, .result = grid(), .columns = columns, .rows = rows};
}

/// One offer of every kind and more, with the English of it.
std::vector<Worded> offers()
{
    using Kind = RepairOffer::Kind;
    return {
        {tilt(0, 0), "Shear the tilt out",
            "Every slice is shifted in its own plane until all lie straight behind each other; "
            "slices lie 2.5 mm apart."},
        {tilt(0, 9), "Shear the tilt out",
            "Every slice is shifted in its own plane until all lie straight behind each other; the "
            "picture grows by 9 rows, and slices lie 2.5 mm apart."},
        {tilt(1, 1), "Shear the tilt out",
            "Every slice is shifted in its own plane until all lie straight behind each other; the "
            "picture grows by 1 column and 1 row, and slices lie 2.5 mm apart."},
        {{.kind = Kind::FillGaps, .result = grid(), .made = 1, .kept = 5}, "Fill the gap",
            "1 slice is interpolated from the neighbouring slices, 5 keep their values; all lie "
            "2.5 mm apart."},
        {{.kind = Kind::FillGaps, .result = grid(), .made = 3, .kept = 3}, "Fill the gaps",
            "3 slices are interpolated from the neighbouring slices, 3 keep their values; all lie "
            "2.5 mm apart."},
        {{.kind = Kind::EvenSpacing, .result = grid(), .kept = 7}, "Resample to even spacing",
            "6 slices 2.5 mm apart, interpolated between the 7 that there are."},
        {{.kind = Kind::Part, .result = grid(), .first = 3, .last = 8, .part = 2, .parts = 4},
            "Split: slices 3–8 only", "Part 2 of 4 is opened alone, its voxels as they are."},
        {{.kind = Kind::Part, .result = grid(), .first = 3, .last = 3, .part = 2, .parts = 4},
            "Split: slice 3 only", "Part 2 of 4 is opened alone, its voxels as they are."},
        {{.kind = Kind::FirstDuplicates, .result = grid()}, "Drop duplicates, keep the first",
            "Of several images at one place the one with the least instance number is taken."},
        {{.kind = Kind::LastDuplicates, .result = grid()}, "Drop duplicates, keep the last",
            "Of several images at one place the one with the greatest instance number is taken."},
        {{.kind = Kind::GivenSpacing, .result = grid()}, "0.5 × 0.75 × 2.5 mm",
            "As given on opening. Opened as it is, it asks for it again."},
        {{.kind = Kind::OtherStack, .result = grid(), .stack = QStringLiteral("stack 2 of 3")},
            "Open stack 2 of 3", "Another stack of the series: 4 × 5 × 6 voxels."},
        {{.kind = Kind::AsRepaired, .repair = QStringLiteral("tilt,gap=fill")},
            "As repaired (tilt,gap=fill)", ""},
    };
}

} // namespace

/// What is said of the repairs of a series.
class RepairTextsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyOffer()
    {
        for (const Worded& worded : offers()) {
            QCOMPARE(ui::repairTitle(worded.offer), QString::fromUtf8(worded.title));
            QCOMPARE(ui::repairEffect(worded.offer), QString::fromUtf8(worded.effect));
        }
    }

    void everyTextGoesThroughTheTranslator()
    {
        const test::MarkingTranslator translator;
        for (const Worded& worded : offers()) {
            for (const QString& text :
                {ui::repairTitle(worded.offer), ui::repairEffect(worded.offer)})
                QVERIFY2(text.isEmpty() || (text.startsWith(u'<') && text.endsWith(u'>')),
                    qPrintable(text));
        }
    }
};

BURIN_TEST(RepairTextsTest)

} // namespace repairTextsTest

#include "RepairTextsTest.moc"
