// SPDX-License-Identifier: Apache-2.0
#include "core/recipe/RecipeExport.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

namespace recipeExportTest {

using namespace core;

/// What a recipe may say of an export.
class RecipeExportTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Formats that hold the codes of segments take them; others say that they do not know them.
    void codesOfSegments()
    {
        for (const ExportFormatFacts& format : exportFormats()) {
            QJsonObject target{{QStringLiteral("format"), QLatin1String(format.name)},
                {QStringLiteral("file"), QStringLiteral("out") + QLatin1String(format.ending)}};
            QVERIFY2(exportFromJson(target), format.name);
            target[QStringLiteral("codes")] =
                QJsonDocument::fromJson(R"({"Cyst": {"region": ["SCT", "64033007", "Kidney"]}})")
                    .object();
            const Result<RecipeExport> read = exportFromJson(target);
            QCOMPARE(read.has_value(), format.holdsCodes);
            if (read)
                QCOMPARE(read->codes.at(QStringLiteral("Cyst")).region.value,
                    QStringLiteral("64033007"));
            else
                QVERIFY2(
                    read.error().arguments.join(QLatin1Char(' ')).contains(QStringLiteral("codes")),
                    format.name);
        }
        QVERIFY(factsOf(ExportFormat::SegNrrd).holdsCodes);
        QVERIFY(!factsOf(ExportFormat::Nifti).holdsCodes);
    }
};

BURIN_TEST(RecipeExportTest)

} // namespace recipeExportTest

#include "RecipeExportTest.moc"
