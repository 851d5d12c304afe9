// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/NumberText.h"
#include "ui/widgets/fields/NumberField.h"

#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

namespace numberFieldUiTest {

namespace {

QString text(const char* utf8)
{
    return QString::fromUtf8(utf8);
}

/// Replaces what stands in a field, key by key, as a user does.
void type(QAbstractSpinBox& field, const QString& typed)
{
    field.show();
    field.selectAll();
    for (const QChar character : typed)
        QTest::sendKeyEvent(QTest::Click, &field, Qt::Key_unknown, QString(character), {});
}

void paste(QAbstractSpinBox& field, const QString& pasted)
{
    field.show();
    QApplication::clipboard()->setText(pasted);
    field.selectAll();
    field.findChild<QLineEdit*>()->paste();
}

} // namespace

/// Fields write the true minus sign and take either.
class NumberFieldUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void numbersAreWrittenAsElsewhere()
    {
        ui::NumberField field;
        field.setRange(-2000.0, 2000.0);
        field.setDecimals(1);
        field.setSuffix(text(" HU"));
        field.setValue(-1024.5);
        QCOMPARE(field.text(), ui::numberText(-1024.5, 1) + text(" HU"));
        QVERIFY(field.text().startsWith(text("−")));
        field.setValue(1024.5);
        QCOMPARE(field.cleanText(), ui::numberText(1024.5, 1));
        field.setValue(-0.04);
        QCOMPARE(field.cleanText(), ui::numberText(0.0, 1));

        ui::WholeNumberField whole;
        whole.setRange(-50, 50);
        whole.setValue(-10);
        QCOMPARE(whole.text(), text("−10"));
        whole.stepUp();
        QCOMPARE(whole.text(), text("−9"));
        whole.setValue(10);
        QCOMPARE(whole.text(), text("10"));
    }

    void eitherSignIsTaken_data()
    {
        QTest::addColumn<QString>("sign");
        QTest::addColumn<bool>("isPasted");
        QTest::newRow("hyphen, typed") << text("-") << false;
        QTest::newRow("minus sign, typed") << text("−") << false;
        QTest::newRow("hyphen, pasted") << text("-") << true;
        QTest::newRow("minus sign, pasted") << text("−") << true;
    }
    void eitherSignIsTaken()
    {
        QFETCH(QString, sign);
        QFETCH(bool, isPasted);
        const auto put = isPasted ? &paste : &type;
        ui::NumberField field;
        field.setRange(-2000.0, 2000.0);
        field.setDecimals(1);
        field.setPrefix(text("to "));
        field.setSuffix(text(" HU"));
        const QSignalSpy changes(&field, &QDoubleSpinBox::valueChanged);
        const QString half = QLocale().toString(12.5, 'f', 1);
        put(field, sign + half);
        QCOMPARE(field.value(), -12.5); // before typing has ended
        QCOMPARE(field.cleanText(), text("−") + half);
        QVERIFY(changes.count() > 0);
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(field.value(), -12.5);
        QCOMPARE(field.text(), text("to −") + half + text(" HU"));

        ui::WholeNumberField whole;
        whole.setRange(-50, 50);
        put(whole, sign + text("7"));
        QCOMPARE(whole.value(), -7);
        QTest::keyClick(&whole, Qt::Key_Return);
        QCOMPARE(whole.value(), -7);
        QCOMPARE(whole.text(), text("−7"));
    }

    void whatEndsLaterTakesEither()
    {
        ui::NumberField field;
        field.setRange(-2000.0, 2000.0);
        field.setDecimals(0);
        field.setKeyboardTracking(false);
        const QSignalSpy changes(&field, &QDoubleSpinBox::valueChanged);
        type(field, text("-31"));
        QCOMPARE(changes.count(), 0);
        QCOMPARE(field.text(), text("−31"));
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(changes.count(), 1);
        QCOMPARE(field.value(), -31.0);
        // A part that is taken away and typed anew.
        field.findChild<QLineEdit*>()->end(false);
        QTest::keyClick(&field, Qt::Key_Backspace);
        QTest::keyClicks(&field, text("5"));
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(field.text(), text("−35"));
        QCOMPARE(field.value(), -35.0);
    }

    void asMuchIsTakenAsByAnyField_data()
    {
        QTest::addColumn<double>("lowest");
        QTest::newRow("numbers below zero") << -20.0;
        QTest::newRow("from zero on") << 0.0;
        QTest::newRow("from one on") << 1.0;
    }
    void asMuchIsTakenAsByAnyField()
    {
        QFETCH(double, lowest);
        const QChar decimalSign = QLocale().decimalPoint().front();
        QDoubleSpinBox plain;
        ui::NumberField field;
        for (QDoubleSpinBox* each : {&plain, static_cast<QDoubleSpinBox*>(&field)}) {
            each->setDecimals(1);
            each->setRange(lowest, 100.0);
        }
        for (const char* form :
            {"", "-", "-5", "-5.5", "-.", "-5.55", "-500", "--5", "5-", "5", "x"}) {
            const QString hyphened = text(form).replace(u'.', decimalSign);
            const QString withSign = QString(hyphened).replace(u'-', ui::minusSign);
            QString taken = hyphened;
            int position = int(taken.size());
            const QValidator::State expected = plain.validate(taken, position);
            for (QString typed : {hyphened, withSign}) {
                position = int(typed.size());
                QVERIFY2(field.validate(typed, position) == expected, form);
                QVERIFY2(!typed.startsWith(u'-'), form);
                QCOMPARE(position, int(typed.size()));
            }
        }
    }

    void wordsKeepTheirHyphens()
    {
        ui::WholeNumberField port;
        port.setRange(0, 65535);
        port.setSpecialValueText(text("over the same connection (C-GET)"));
        port.setPrefix(text("to our port "));
        port.setSuffix(text(" (C-MOVE)"));
        QCOMPARE(port.text(), text("over the same connection (C-GET)"));
        type(port, text("104"));
        QTest::keyClick(&port, Qt::Key_Return);
        QCOMPARE(port.value(), 104);
        QCOMPARE(port.text(), text("to our port 104 (C-MOVE)"));
        type(port, text("0"));
        QTest::keyClick(&port, Qt::Key_Return);
        QCOMPARE(port.text(), text("over the same connection (C-GET)"));

        ui::NumberField softness;
        softness.setRange(-1.0, 10.0);
        softness.setSpecialValueText(text("-none-"));
        softness.setValue(-1.0);
        softness.interpretText();
        QCOMPARE(softness.text(), text("-none-"));
        QCOMPARE(softness.value(), -1.0);
    }
};

BURIN_WINDOW_TEST(NumberFieldUiTest)

} // namespace numberFieldUiTest

#include "NumberFieldUiTest.moc"
