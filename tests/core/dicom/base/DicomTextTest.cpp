// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/DicomText.h"
#include "core/dicom/base/TextsToUtf8.h"
#include "core/dicom/items/ItemReader.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace dicomTextTest {

using namespace core;

class DicomTextTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void textsOfEveryCharacterSet_data()
    {
        QTest::addColumn<QByteArray>("characterSet");
        QTest::addColumn<QByteArray>("stored");
        QTest::addColumn<QString>("text");
        const QByteArray japanese("\\ISO 2022 IR 87");
        QTest::newRow("ASCII") << QByteArray() << QByteArray(" Liver ") << QStringLiteral("Liver");
        QTest::newRow("Latin-1") << QByteArray("ISO_IR 100")
                                 << QByteArray("Sch\xe4"
                                               "del")
                                 << QStringLiteral("Schädel");
        QTest::newRow("Latin-1, undeclared") << QByteArray()
                                             << QByteArray("Sch\xe4"
                                                           "del")
                                             << QStringLiteral("Schädel");
        QTest::newRow("UTF-8, undeclared")
            << QByteArray() << QStringLiteral("Schädel").toUtf8() << QStringLiteral("Schädel");
        // PS3.5 annex H, example 1.
        QTest::newRow("Japanese")
            << japanese
            << QByteArray("Yamada^Tarou=\033$B;3ED\033(B^\033$BB@O:\033(B=\033$B$d$^$@\033(B^"
                          "\033$B$?$m$&\033(B")
            << QStringLiteral("Yamada^Tarou=山田^太郎=やまだ^たろう");
        // 秀 is 3D 28 and 十 is 3D 3D, in which 3D is no delimiter.
        QTest::newRow("Japanese, delimiters within")
            << japanese << QByteArray("\033$B=(\033(B=\033$B==\033(B=x")
            << QStringLiteral("秀=十=x");
        QTest::newRow("Japanese, several values")
            << japanese << QByteArray("\033$B;3\033(B\\\033$BED\033(B") << QStringLiteral("山\\田");
        QTest::newRow("Japanese, never back to ASCII")
            << japanese << QByteArray("\033$B==") << QStringLiteral("十");
        QTest::newRow("Katakana of one byte, several values")
            << QByteArray("ISO 2022 IR 13\\ISO 2022 IR 87") << QByteArray("\xd4\xcf\\\xc0")
            << QStringLiteral("ﾔﾏ\\ﾀ");
    }
    void textsOfEveryCharacterSet()
    {
        QFETCH(QByteArray, characterSet);
        QFETCH(QByteArray, stored);
        QFETCH(QString, text);
        QCOMPARE(dicomText(stored, characterSet), text);
    }

    /// Items of sequences may declare character sets of their own, and have their parent's if not.
    void allTextsOfADataSet()
    {
        DcmDataset set;
        DcmItem* inner = nullptr;
        DcmItem* other = nullptr;
        QVERIFY(set.putAndInsertString(DCM_SpecificCharacterSet, "\\ISO 2022 IR 87").good());
        QVERIFY(set.putAndInsertString(DCM_PatientName, "\033$B;3ED\033(B").good());
        QVERIFY(set.findOrCreateSequenceItem(DCM_SegmentSequence, inner, -2).good());
        QVERIFY(inner->putAndInsertString(DCM_SegmentLabel, "\033$BF,It\033(B").good());
        QVERIFY(set.findOrCreateSequenceItem(DCM_SegmentSequence, other, -2).good());
        QVERIFY(other->putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 144").good());
        QVERIFY(other->putAndInsertString(DCM_SegmentLabel, "\xbb\xee\xda\xd1").good());
        QVERIFY(other->putAndInsertString(DCM_SegmentDescription, "plain text").good());
        textsToUtf8(set);
        QCOMPARE(ItemReader(&set).text(DCM_SpecificCharacterSet), QStringLiteral("ISO_IR 192"));
        QCOMPARE(ItemReader(&set).text(DCM_PatientName), QStringLiteral("山田"));
        QCOMPARE(ItemReader(inner).text(DCM_SegmentLabel), QStringLiteral("頭部"));
        QCOMPARE(ItemReader(other).text(DCM_SegmentLabel), QStringLiteral("Люкб"));
        QCOMPARE(ItemReader(other).text(DCM_SegmentDescription), QStringLiteral("plain text"));
        QVERIFY(!other->tagExists(DCM_SpecificCharacterSet));
    }
};

BURIN_TEST(DicomTextTest)

} // namespace dicomTextTest

#include "DicomTextTest.moc"
