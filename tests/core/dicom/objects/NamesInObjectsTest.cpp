// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/Dcmtk.h"
#include "core/dicom/objects/RtStructFile.h"
#include "core/dicom/objects/SrReader.h"
#include "tests/support/program/TestProgram.h"

#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace namesInObjectsTest {

using namespace core;

namespace {

void put(DcmItem* item, const DcmTagKey& tag, const QByteArray& value)
{
    if (item == nullptr || item->putAndInsertString(tag, value.constData()).bad())
        qFatal("cannot be put");
}

DcmItem* itemIn(DcmItem* parent, const DcmTagKey& sequence)
{
    DcmItem* item = nullptr;
    if (parent == nullptr || parent->findOrCreateSequenceItem(sequence, item, -2).bad())
        qFatal("no item");
    return item;
}

} // namespace

/// Names that other programs gave, in their character sets.
class NamesInObjectsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void names_data()
    {
        QTest::addColumn<QByteArray>("characterSet");
        QTest::addColumn<QByteArray>("stored");
        QTest::addColumn<QString>("name");
        QTest::newRow("Japanese") << QByteArray("\\ISO 2022 IR 87")
                                  << QByteArray("\033$BF,It\033(B 1") << QStringLiteral("頭部 1");
        QTest::newRow("Latin-1, undeclared") << QByteArray()
                                             << QByteArray("Sch\xe4"
                                                           "del")
                                             << QStringLiteral("Schädel");
        QTest::newRow("UTF-8, undeclared")
            << QByteArray() << QStringLiteral("Schädel").toUtf8() << QStringLiteral("Schädel");
    }
    void names()
    {
        QFETCH(QByteArray, characterSet);
        QFETCH(QByteArray, stored);
        QFETCH(QString, name);
        readyDcmtk();
        QTemporaryDir folder;
        const QString contours = folder.filePath(QStringLiteral("contours.dcm"));
        DcmFileFormat structure;
        DcmDataset* set = structure.getDataset();
        put(set, DCM_SOPClassUID, UID_RTStructureSetStorage);
        put(set, DCM_SOPInstanceUID, "2.25.99");
        if (!characterSet.isEmpty())
            put(set, DCM_SpecificCharacterSet, characterSet);
        // A text before it that cannot be converted either.
        put(set, DCM_StructureSetLabel, stored);
        put(itemIn(set, DCM_StructureSetROISequence), DCM_ROIName, stored);
        QVERIFY(structure.saveFile(qPrintable(contours), EXS_LittleEndianImplicit).good());
        const auto read = readRtStruct(contours);
        QVERIFY(read);
        QCOMPARE(read->rois.front().name, name);

        const QString measured = folder.filePath(QStringLiteral("report.dcm"));
        DcmFileFormat report;
        set = report.getDataset();
        put(set, DCM_SOPClassUID, UID_Comprehensive3DSRStorage);
        put(set, DCM_SOPInstanceUID, "2.25.98");
        if (!characterSet.isEmpty())
            put(set, DCM_SpecificCharacterSet, characterSet);
        put(itemIn(set, DCM_ConceptNameCodeSequence), DCM_CodeValue, "126000");
        DcmItem* part = itemIn(set, DCM_ContentSequence);
        put(itemIn(part, DCM_ConceptNameCodeSequence), DCM_CodeValue, "126010");
        DcmItem* text = itemIn(itemIn(part, DCM_ContentSequence), DCM_ContentSequence);
        put(itemIn(text, DCM_ConceptNameCodeSequence), DCM_CodeValue, "112039");
        put(text, DCM_TextValue, stored);
        QVERIFY(report.saveFile(qPrintable(measured), EXS_LittleEndianExplicit).good());
        const auto numbers = readSr(measured);
        QVERIFY(numbers);
        QCOMPARE(numbers->groups.size(), std::size_t(1));
        QCOMPARE(numbers->groups.front().name, name);
    }
};

BURIN_TEST(NamesInObjectsTest)

} // namespace namesInObjectsTest

#include "NamesInObjectsTest.moc"
