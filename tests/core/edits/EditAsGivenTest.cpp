// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditAsGiven.h"
#include "core/edits/EditJson.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/splitting/CopySegment.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace editAsGivenTest {

using namespace core;

/// What a row holds beyond what was given is left out, and nothing else.
class EditAsGivenTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatWasFoundIsLeftOut()
    {
        const DivideSegment divided{
            .segment = 1, .marginMm = 7.0, .probabilities = QByteArray("map")};
        DivideSegment division = divided;
        division.owners = {{.label = 1, .voxels = QByteArray("runs")}};
        QVERIFY(asFirstGiven(division).get<DivideSegment>() == divided);
        ChunkToggle toggle{.segment = 1, .chunks = 3, .pointsLps = {{1.0, 2.0, 3.0}}};
        const QJsonObject asGiven = editToJson(toggle);
        toggle.bricks = {4, 5};
        QVERIFY(editToJson(toggle) != asGiven);
        QCOMPARE(editToJson(asFirstGiven(toggle)), asGiven);
    }

    /// The plane that a copy names once it was carried out is its own from then on.
    void whatWasChosenStays()
    {
        const Edit copy = CopySegment{.segment = 1, .name = QStringLiteral("Copy"), .plane = 2};
        QCOMPARE(editToJson(asFirstGiven(copy)), editToJson(copy));
    }
};

BURIN_TEST(EditAsGivenTest)

} // namespace editAsGivenTest

#include "EditAsGivenTest.moc"
