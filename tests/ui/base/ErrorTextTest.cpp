// SPDX-License-Identifier: Apache-2.0
#include "ui/base/ErrorText.h"

#include "tests/support/program/MarkingTranslator.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace errorTextTest {

using core::ErrorCode;

/// What is said of errors.
class ErrorTextTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyCodeGoesThroughTheTranslator()
    {
        const QStringList arguments{
            QStringLiteral("A %2"), QStringLiteral("B"), QStringLiteral("C")};
        for (int code = 0; code <= int(ErrorCode::TransferIncomplete); ++code) {
            const core::Error error{ErrorCode(code), arguments};
            const QString plain = ui::errorText(error);
            QVERIFY2(!plain.isEmpty(), qPrintable(QString::number(code)));
            const test::MarkingTranslator translator;
            const QString marked = ui::errorText(error);
            QVERIFY2(marked.contains(u'<'), qPrintable(marked));
            QCOMPARE(QString(marked).remove(u'<').remove(u'>'), plain);
        }
    }

    void argumentsStandWhereTheyBelong()
    {
        QCOMPARE(ui::errorText({ErrorCode::FileUnreadable, {QStringLiteral("/a/%2.nii")}}),
            QStringLiteral("/a/%2.nii: cannot be read"));
        QCOMPARE(
            ui::errorText({ErrorCode::UnknownSegment, {QStringLiteral("7"), QStringLiteral("x")}}),
            QStringLiteral("there is no segment 7: x"));
    }
};

BURIN_TEST(ErrorTextTest)

} // namespace errorTextTest

#include "ErrorTextTest.moc"
