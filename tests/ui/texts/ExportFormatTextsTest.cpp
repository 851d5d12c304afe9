// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/ExportFormatTexts.h"

#include "tests/support/program/MarkingTranslator.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <set>

namespace exportFormatTextsTest {

/// How the export dialog, its reports and the command line call formats.
class ExportFormatTextsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyFormatHasItsOwnTitleAndASentence()
    {
        std::set<QString> titles;
        for (const core::ExportFormatFacts& facts : core::exportFormats()) {
            const QString says = ui::exportFormatSays(facts.format);
            titles.insert(ui::exportFormatTitle(facts.format));
            QVERIFY2(!says.isEmpty() && says.front().isUpper() && says.endsWith(u'.'), facts.name);
        }
        QCOMPARE(titles.size(), core::exportFormats().size());
        QVERIFY(!titles.contains(QString()));
        QVERIFY(titles.contains(QStringLiteral("DICOM SEG, label map")));
        QVERIFY(ui::exportFormatSays(core::ExportFormat::DicomSegFractional)
                    .contains(QStringLiteral(", 0 … 255, ")));
    }

    void allIsTranslated()
    {
        const test::MarkingTranslator translator;
        for (const core::ExportFormatFacts& facts : core::exportFormats()) {
            for (const QString& text :
                {ui::exportFormatTitle(facts.format), ui::exportFormatSays(facts.format)})
                QVERIFY2(text.startsWith(u'<') && text.endsWith(u'>'), qPrintable(text));
        }
    }
};

BURIN_TEST(ExportFormatTextsTest)

} // namespace exportFormatTextsTest

#include "ExportFormatTextsTest.moc"
