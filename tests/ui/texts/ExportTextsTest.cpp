// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/ExportTexts.h"

#include "tests/support/program/MarkingTranslator.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace exportTextsTest {

using core::ExportRemark;

/// What the export dialogs say of codes of core.
class ExportTextsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void remarks()
    {
        const std::vector<std::pair<ExportRemark, const char*>> all{{ExportRemark::Empty, "empty"},
            {ExportRemark::Hidden, "hidden"},
            {ExportRemark::GrowthNotFinished, "growth not finished"},
            {ExportRemark::SurfaceNotWrittenBack, "surface not written back"},
            {ExportRemark::NotCoded, "not coded yet"}};
        for (const auto& [remark, text] : all)
            QCOMPARE(ui::exportRemarkText(remark), QString::fromUtf8(text));
        const test::MarkingTranslator translator;
        for (const auto& [remark, text] : all)
            QCOMPARE(ui::exportRemarkText(remark), u'<' + QString::fromUtf8(text) + u'>');
    }
};

BURIN_TEST(ExportTextsTest)

} // namespace exportTextsTest

#include "ExportTextsTest.moc"
