// SPDX-License-Identifier: Apache-2.0
#include "ui/base/ErrorText.h"

#include "core/recipe/Recipe.h"
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

    /// Also where a sentence has no place for a reason, and none of its numbers is to carry it.
    void theEntryOfARecipeIsTold()
    {
        const auto textAt = [](ErrorCode code, const QStringList& arguments) {
            return ui::errorText(core::atEdit({code, arguments}, 4));
        };
        QCOMPARE(textAt(ErrorCode::InvalidField, {QStringLiteral("x"), QStringLiteral("missing")}),
            QStringLiteral("field 'x': missing (edit 4)"));
        QCOMPARE(textAt(ErrorCode::SegmentLocked, {QStringLiteral("A")}),
            QStringLiteral("segment 'A' is locked (edit 4)"));
        QCOMPARE(textAt(ErrorCode::SegmentLocked, {}),
            QStringLiteral("every segment is locked (edit 4)"));
        const QString islands = textAt(ErrorCode::TooManyIslands,
            {QStringLiteral("A"), QStringLiteral("12"), QStringLiteral("3")});
        QVERIFY2(islands.contains(QStringLiteral("has 12 islands"))
                && islands.endsWith(QStringLiteral("stay with it (edit 4)")),
            qPrintable(islands));
        QVERIFY(textAt(ErrorCode::NothingGrown, {}).endsWith(QStringLiteral("places (edit 4)")));
    }
};

BURIN_TEST(ErrorTextTest)

} // namespace errorTextTest

#include "ErrorTextTest.moc"
