// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/CodeDialog.h"

#include "ui/base/SegmentCodes.h"

#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>
#include <QtTest>

#include <set>

namespace codeDialogUiTest {

class CodeDialogUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theListIsSound()
    {
        const auto& codes = ui::segmentCodes();
        QVERIFY(codes.size() >= 40);
        std::set<QString> values;
        std::set<QString> meanings;
        for (const ui::SegmentCode& entry : codes) {
            QVERIFY2(ui::isSnomedIdentifier(entry.code.value), qPrintable(entry.code.value));
            QVERIFY(!entry.code.meaning.isEmpty());
            QVERIFY(!entry.group.isEmpty());
            QVERIFY2(values.insert(entry.code.value).second, qPrintable(entry.code.value));
            QVERIFY2(meanings.insert(entry.code.meaning).second, qPrintable(entry.code.meaning));
        }
        QVERIFY(values.count(QStringLiteral("89546000")) == 1);
    }

    void aWrongDigitIsNoticed()
    {
        QVERIFY(ui::isSnomedIdentifier(QStringLiteral("89546000")));
        for (const char* wrong : {"89546001", "98546000", "8954600", "89546O00", "", "12345"})
            QVERIFY2(!ui::isSnomedIdentifier(QLatin1String(wrong)), wrong);
    }

    void aFewLettersFindAConcept()
    {
        ui::CodeDialog dialog(QStringLiteral("Segment 1"), {});
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        QVERIFY(!ok->isEnabled());
        auto* search = dialog.findChild<QLineEdit*>(QStringLiteral("codeSearch"));
        QTest::keyClicks(search, QStringLiteral("skul"));
        QVERIFY(ok->isEnabled());
        const core::CodedConcept code = dialog.code();
        QCOMPARE(code.scheme, QStringLiteral("SCT"));
        QCOMPARE(code.value, QStringLiteral("89546000"));
        QCOMPARE(code.meaning, QStringLiteral("Skull"));
        QTest::keyClick(search, Qt::Key_Return);
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
    }

    /// A segment that is called what it is needs one key.
    void theNameIsTheFirstGuess()
    {
        ui::theme::apply(*qApp);
        ui::CodeDialog dialog(QStringLiteral("skull"), {});
        dialog.askDetails({});
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        QVERIFY(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
        QCOMPARE(dialog.code().value, QStringLiteral("89546000"));
        // What the fields of both forms begin at.
        QCOMPARE(dialog.findChild<QWidget*>(QStringLiteral("codeCategory"))
                     ->mapTo(&dialog, QPoint())
                     .x(),
            dialog.findChild<QWidget*>(QStringLiteral("codeValue"))->mapTo(&dialog, QPoint()).x());
        test::look(dialog.grab(), "code-dialog.png");
        const core::CodedConcept liver{
            QStringLiteral("SCT"), QStringLiteral("10200004"), QStringLiteral("Liver")};
        QCOMPARE(ui::CodeDialog(QStringLiteral("skull"), liver).code(), liver);
    }

    void anyOtherConceptIsTyped()
    {
        ui::CodeDialog dialog(QStringLiteral("Segment 1"), {});
        auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        auto* value = dialog.findChild<QLineEdit*>(QStringLiteral("codeValue"));
        auto* meaning = dialog.findChild<QLineEdit*>(QStringLiteral("codeMeaning"));
        value->setText(QStringLiteral("21082006"));
        meaning->setText(QStringLiteral("Maxillary sinus"));
        QVERIFY(!ok->isEnabled());
        value->setText(QStringLiteral("21082005"));
        QVERIFY(ok->isEnabled());
        meaning->clear();
        QVERIFY(!ok->isEnabled());
    }
};

BURIN_WINDOW_TEST(CodeDialogUiTest)

} // namespace codeDialogUiTest

#include "CodeDialogUiTest.moc"
