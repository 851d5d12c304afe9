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

    /// What is of another kind than it should be is refused, and the field is named.
    void otherKindsOfValuesAreRefused_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::addColumn<QString>("field");
        const auto row = [](const char* name, const char* json, const char* field) {
            QTest::newRow(name) << QByteArray(json) << QString(QLatin1String(field));
        };
        row("a code without its field",
            R"({"format": "dicom-seg", "file": "a.dcm", "codes":
                {"Liver": ["SCT", "10200004", "Liver"]}})",
            "export.codes");
        row("no codes", R"({"format": "dicom-seg", "file": "a.dcm", "codes": {"Liver": null}})",
            "export.codes");
        row("algorithm", R"({"format": "dicom-seg", "file": "a.dcm", "algorithm": 1})",
            "export.algorithm");
        row("empty algorithm", R"({"format": "dicom-seg", "file": "a.dcm", "algorithm": null})",
            "export.algorithm");
        row("space", R"({"format": "stl", "file": "a.stl", "space": 1})", "export.space");
        row("space in a list", R"({"format": "stl", "file": "a.stl", "space": ["RAS"]})",
            "export.space");
    }
    void otherKindsOfValuesAreRefused()
    {
        QFETCH(QByteArray, json);
        QFETCH(QString, field);
        const Result<RecipeExport> read = exportFromJson(QJsonDocument::fromJson(json).object());
        QVERIFY(!read);
        QCOMPARE(read.error().code, ErrorCode::InvalidField);
        QCOMPARE(read.error().arguments.value(0), field);
    }
    /// What is not said is as usual.
    void whatIsNotSaidIsAsUsual()
    {
        const auto read = [](const char* json) {
            return exportFromJson(QJsonDocument::fromJson(json).object());
        };
        const auto seg = read(R"({"format": "dicom-seg", "file": "a.dcm"})");
        QVERIFY(seg && seg->seg.algorithm == SegAlgorithm::Semiautomatic);
        const auto surface = read(R"({"format": "stl", "file": "a.stl"})");
        QVERIFY(surface && surface->space == MeshSpace::Lps);
        const auto other = read(R"({"format": "stl", "file": "a.stl", "space": "RAS"})");
        QVERIFY(other && other->space == MeshSpace::Ras);
    }
};

BURIN_TEST(RecipeExportTest)

} // namespace recipeExportTest

#include "RecipeExportTest.moc"
