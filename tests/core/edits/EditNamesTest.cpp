// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditNames.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace editNamesTest {

using namespace core;

using Rows = std::vector<std::int64_t>;

/// What an edit names that is not in the document is found in it.
class EditNamesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void rowsAreNamedForAPurpose()
    {
        const NamedRows taken = rowsNamedBy(RevertRows{.rows = {2, 5}});
        QCOMPARE(taken.use, RowUse::TakesBack);
        QCOMPARE(taken.rows, (Rows{2, 5}));
        const NamedRows revised = rowsNamedBy(ReviseStroke{.row = 3, .depthMm = 4.0});
        QCOMPARE(revised.use, RowUse::Revises);
        QCOMPARE(revised.rows, Rows{3});
        const NamedRows none = rowsNamedBy(DrillStroke());
        QCOMPARE(none.use, RowUse::None);
        QCOMPARE(none.rows, Rows());
    }

    void onlySomeAreTakenBack()
    {
        QCOMPARE(rowsTakenBackBy(RevertRows{.rows = {2, 5}}), (Rows{2, 5}));
        QCOMPARE(rowsTakenBackBy(ReviseStroke{.row = 3}), Rows());
        QCOMPARE(rowsTakenBackBy(DrillStroke()), Rows());
    }

    void rowsGetOtherNumbers()
    {
        const auto next = [](std::int64_t& row) { ++row; };
        Edit revert = RevertRows{.rows = {2, 5}};
        changeRowsNamed(revert, next);
        QCOMPARE(revert.get<RevertRows>().rows, (Rows{3, 6}));
        Edit revise = ReviseStroke{.row = 3};
        changeRowsNamed(revise, next);
        QCOMPARE(revise.get<ReviseStroke>().row, std::int64_t(4));
        Edit drill = DrillStroke{.layer = 7};
        changeRowsNamed(drill, next);
        QCOMPARE(drill.get<DrillStroke>().layer, 7);
    }

    void filesGetOtherNames()
    {
        const auto rename = [](QString& file) { file = QStringLiteral("other.") + file; };
        Edit mask = ImportMask{.file = QStringLiteral("a.nrrd")};
        changeFilesNamed(mask, rename);
        QCOMPARE(mask.get<ImportMask>().file, QStringLiteral("other.a.nrrd"));
        Edit division = DivideSegment{.segment = 1, .probabilityFile = QStringLiteral("b.nrrd")};
        changeFilesNamed(division, rename);
        QCOMPARE(division.get<DivideSegment>().probabilityFile,
            std::optional(QStringLiteral("other.b.nrrd")));
        // One that was carried out names none.
        Edit done = DivideSegment{.segment = 1};
        changeFilesNamed(done, rename);
        QVERIFY(!done.get<DivideSegment>().probabilityFile);
        Edit drill = DrillStroke();
        changeFilesNamed(drill, [](QString&) { QFAIL("it names no file"); });
    }

    /// Those of people, not the program's own.
    void textsAreThoseOfPeople()
    {
        const ImportedSegment segment{.name = QStringLiteral("Mine"),
            .rgb = 0x804020,
            .code = {.scheme = QStringLiteral("99MINE"),
                .value = QStringLiteral("1"),
                .meaning = QStringLiteral("Yours")},
            .voxels = QByteArray("voxels")};
        ImportMask mask{.file = QStringLiteral("a.nrrd")};
        mask.segments = std::vector<ImportedSegment>{segment};
        QStringList texts = textsIn(mask);
        texts.sort();
        QCOMPARE(texts,
            (QStringList{QStringLiteral("1"), QStringLiteral("99MINE"), QStringLiteral("Mine"),
                QStringLiteral("Yours"), QStringLiteral("a.nrrd")}));
        QCOMPARE(textsIn(DrillStroke()), QStringList());
    }
};

BURIN_TEST(EditNamesTest)

} // namespace editNamesTest

#include "EditNamesTest.moc"
