// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/deidentify/Deidentifier.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/MarkedSeries.h"

#include <QByteArrayList>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <vector>

namespace confidentialAttributesTest {

using namespace core;

namespace {

/// Attributes that PS3.15 table E.1-1 has removed, emptied or replaced, and some of their kind.
constexpr const char* confidential =
    "00080012 00080013 00080014 00080015 00080017 00080018 00080020 00080021 00080022 "
    "00080023 00080024 00080025 0008002A 00080030 00080031 00080032 00080033 00080034 "
    "00080035 00080050 00080051 00080055 00080058 00080080 00080081 00080082 00080090 "
    "00080092 00080094 00080096 0008009C 0008009D 0008010D 00080201 00081010 00081030 "
    "0008103E 0008103F 00081040 00081041 00081048 00081049 00081050 00081052 00081060 "
    "00081062 00081070 00081072 00081080 00081084 00081088 00081110 00081111 00081120 "
    "00081140 00081155 00081195 00082111 00082112 00083010 00084000 00089123 00100010 "
    "00100020 00100021 00100022 00100024 00100030 00100032 00100033 00100034 00100035 "
    "00100040 00100050 00100101 00100102 00101000 00101001 00101002 00101005 00101010 "
    "00101020 00101021 00101030 00101040 00101050 00101060 00101080 00101081 00101090 "
    "00101100 00102000 00102110 00102150 00102152 00102154 00102155 00102160 00102180 "
    "001021A0 001021B0 001021C0 001021D0 001021F0 00102203 00102292 00102293 00102294 "
    "00102295 00102296 00102297 00102298 00102299 00104000 00120010 00120020 00120021 "
    "00120030 00120031 00120040 00120042 00120050 00120051 00120060 00120071 00120072 "
    "00120081 00120082 00180010 00181000 00181002 00181003 00181004 00181005 00181007 "
    "00181008 00181009 00181010 00181011 00181012 00181014 00181030 00181072 00181073 "
    "00181078 00181079 00181200 00181201 00181400 00182042 00184000 0018700A 0018700C "
    "0018700E 00189074 00189151 00189424 00189516 00189517 00189623 0018A002 0018A003 "
    "0020000D 0020000E 00200010 00200052 00200200 00203401 00203403 00203405 00203406 "
    "00204000 00209158 00209161 00209164 00281199 00281214 00284000 00320012 00320032 "
    "00320033 00320034 00320035 00321000 00321001 00321010 00321011 00321020 00321021 "
    "00321030 00321031 00321032 00321033 00321034 00321040 00321041 00321050 00321051 "
    "00321055 00321060 00321070 00324000 00380004 00380010 00380011 00380014 00380016 "
    "0038001A 0038001B 0038001C 0038001D 0038001E 00380020 00380021 00380030 00380032 "
    "00380040 00380044 00380050 00380060 00380061 00380062 00380300 00380400 00380500 "
    "00384000 00400001 00400002 00400003 00400004 00400005 00400006 00400007 00400009 "
    "0040000B 00400010 00400011 00400012 00400241 00400242 00400243 00400244 00400245 "
    "00400250 00400251 00400253 00400254 00400275 00400280 00400310 00400512 00400513 "
    "00400551 00400554 00400555 00400560 0040059A 00400600 00400602 00401001 00401002 "
    "00401003 00401004 00401005 00401006 00401007 00401008 00401010 00401011 00401101 "
    "00401102 00401103 00401104 00401400 00402001 00402004 00402005 00402006 00402007 "
    "00402008 00402009 00402010 00402011 00402016 00402017 00402400 00403001 00404005 "
    "00404009 00404010 00404011 00404023 00404025 00404027 00404028 00404030 00404034 "
    "00404035 00404036 00404037 00404050 00404051 00404052 0040A023 0040A024 0040A027 "
    "0040A030 0040A032 0040A073 0040A075 0040A078 0040A07A 0040A07C 0040A082 0040A088 "
    "0040A110 0040A120 0040A121 0040A122 0040A123 0040A124 0040A13A 0040A160 0040A171 "
    "0040A172 0040A192 0040A193 0040A301 0040A307 0040A313 0040A33A 0040A352 0040A353 "
    "0040A354 0040A358 0040A402 0040A730 0040DB0C 0040DB0D 00620021 00640003 00700001 "
    "00700084 00700086 0070031A 00701101 00701102 00880140 00880200 00880904 00880906 "
    "00880910 00880912 04000100 04000105 04000115 04000120 04000305 04000310 04000402 "
    "04000403 04000404 04000500 04000520 04000550 04000561 04000562 04000563 04000564 "
    "04000565 20300020 30060002 30060004 30060006 30060008 30060009 30060024 30060026 "
    "30060028 30060038 30060085 30060088 300600A6 300600C2 30080024 30080025 30080054 "
    "30080056 30080105 30080162 30080164 30080166 30080168 30080250 30080251 300A0002 "
    "300A0003 300A0004 300A0006 300A0007 300A000B 300A000E 300A0013 300A0016 300A0083 "
    "300A00B2 300A00C3 300A00DD 300A0196 300A01A6 300A01B2 300A0216 300A022C 300A022E "
    "300A02EB 300C0113 300E0004 300E0005 300E0008 40000010 40004000 40080042 40080102 "
    "4008010A 4008010B 4008010C 40080111 40080114 40080115 40080118 40080119 4008011A "
    "40080202 40080300 40084000";

std::vector<DcmTag> confidentialTags()
{
    std::vector<DcmTag> tags;
    for (const QByteArray& text : QByteArray(confidential).split(' '))
        tags.emplace_back(
            Uint16(text.left(4).toUInt(nullptr, 16)), Uint16(text.mid(4).toUInt(nullptr, 16)));
    return tags;
}

/// Values without a marker, which are found as a whole.
const QByteArrayList plainValues{"101112", "077Y", "770077", "7707"};

QByteArray valueFor(DcmEVR vr)
{
    switch (vr) {
    case EVR_PN:
        return "MARKERNAME^Otto";
    case EVR_DA:
        return "19330214";
    case EVR_DT:
        return "19330214101112";
    case EVR_TM:
        return "101112";
    case EVR_AS:
        return "077Y";
    case EVR_DS:
    case EVR_FL:
    case EVR_FD:
        return "77.0770770";
    case EVR_IS:
    case EVR_SL:
    case EVR_UL:
        return "770077";
    case EVR_SS:
    case EVR_US:
        return "7707";
    case EVR_UI:
        return "2.25.7700770077123";
    default:
        return "MARKERTEXT";
    }
}

/// @return whether the dictionary knows what it is
bool fill(DcmItem& item, const DcmTag& tag)
{
    if (tag.getEVR() == EVR_SQ) {
        DcmItem* inside = nullptr;
        return item.findOrCreateSequenceItem(tag, inside, -2).good()
            && inside->putAndInsertString(DCM_PatientName, "MARKERNAME^Otto").good()
            && inside->putAndInsertString(DCM_TextValue, "MARKERTEXT").good();
    }
    if (item.putAndInsertString(tag, valueFor(tag.getEVR()).constData()).good())
        return true;
    constexpr Uint8 bytes[] = {'M', 'A', 'R', 'K', 'E', 'R', 'T', 'E', 'X', 'T'};
    return item.putAndInsertUint8Array(tag, bytes, sizeof bytes).good();
}

/// What still tells who the patient is.
void search(DcmItem& item, QStringList& found)
{
    for (unsigned long i = 0; i < item.card(); ++i) {
        DcmElement& element = *item.getElement(i);
        if (auto* sequence = dynamic_cast<DcmSequenceOfItems*>(&element)) {
            for (unsigned long k = 0; k < sequence->card(); ++k)
                search(*sequence->getItem(k), found);
            continue;
        }
        DcmTag tag = element.getTag();
        OFString value;
        element.getOFStringArray(value);
        const QByteArray text(value.c_str());
        const QByteArrayList markers = test::markers();
        const bool isMarked = std::any_of(markers.begin(), markers.end(),
            [&text](const QByteArray& marker) { return text.contains(marker); });
        const bool isBinary = element.ident() == EVR_OB || element.ident() == EVR_OW;
        if (isMarked || isBinary || plainValues.contains(text))
            found += QString::fromLatin1(tag.getTagName()) + u' ' + QString::fromLatin1(text);
    }
}

StudyIdentity patient()
{
    StudyIdentity identity;
    identity.patientName = QStringLiteral("MARKERNAME^Otto");
    identity.patientId = QStringLiteral("MARKERID");
    return identity;
}

} // namespace

/// Attribute by attribute, at the top and in the items of sequences that stay: nothing that an
/// image says of the patient is left of it.
class ConfidentialAttributesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void everyAttributeGoes_data();
    void everyAttributeGoes();
    void whatIsKeptNamesNobody();
    void onlyOwnResultsKeepTheirTexts();
};

void ConfidentialAttributesTest::everyAttributeGoes_data()
{
    QTest::addColumn<QByteArray>("inside");
    QTest::newRow("at the top") << QByteArray();
    // Sequences of images that stay.
    for (const char* name : {"SourceImageSequence", "AnatomicRegionSequence",
             "DerivationImageSequence", "SharedFunctionalGroupsSequence"})
        QTest::newRow(name) << QByteArray(name);
}

void ConfidentialAttributesTest::everyAttributeGoes()
{
    QFETCH(QByteArray, inside);
    DcmDataset set;
    QVERIFY(set.putAndInsertString(DCM_Manufacturer, "Werk 7").good());
    DcmItem* item = &set;
    if (!inside.isEmpty()) {
        DcmTag sequence;
        QVERIFY(DcmTag::findTagFromName(inside.constData(), sequence).good());
        QVERIFY(set.findOrCreateSequenceItem(sequence, item, -2).good());
    }
    const std::vector<DcmTag> tags = confidentialTags();
    for (const DcmTag& tag : tags) {
        DcmTag named = tag;
        QVERIFY2(fill(*item, tag), named.getTagName());
    }
    QStringList found;
    search(set, found);
    QVERIFY2(std::size_t(found.size()) >= tags.size(), "what is looked for can be found");
    Deidentifier({}, patient(), "secret").apply(set);
    found.clear();
    search(set, found);
    QVERIFY2(found.isEmpty(), qPrintable(found.join(QStringLiteral(", "))));
}

void ConfidentialAttributesTest::whatIsKeptNamesNobody()
{
    DcmDataset set;
    for (const DcmTag& tag : confidentialTags())
        QVERIFY(fill(set, tag));
    Deidentifier(
        {.dates = DeidentifyOptions::Dates::Keep, .keepDevice = true, .keepDescriptions = true},
        patient(), "secret")
        .apply(set);
    QStringList found;
    search(set, found);
    for (const QString& attribute : found) {
        const bool isDate =
            attribute.contains(QLatin1String("Date")) || attribute.contains(QLatin1String("Time"));
        // A description, or the scanner's, without the patient's own words.
        const bool isText = attribute.contains(QLatin1String("MARKERTEXT"));
        QVERIFY2(isDate || isText, qPrintable(attribute));
        QVERIFY2(!attribute.contains(QLatin1String("MARKERNAME")), qPrintable(attribute));
    }
    // Of all of them, those that the options name.
    QVERIFY2(found.size() < 30, qPrintable(found.join(QStringLiteral(", "))));
}

/// What Burin writes names segments neutrally before; what others wrote may name anybody.
void ConfidentialAttributesTest::onlyOwnResultsKeepTheirTexts()
{
    for (const bool isOwn : {true, false}) {
        DcmDataset set;
        QVERIFY(set.putAndInsertString(DCM_Manufacturer, isOwn ? "Burin" : "Werk 7").good());
        QVERIFY(set.putAndInsertString(DCM_ROIName, "Liver").good());
        DcmItem* segment = nullptr;
        QVERIFY(set.findOrCreateSequenceItem(DCM_SegmentSequence, segment, -2).good());
        QVERIFY(segment->putAndInsertString(DCM_SegmentLabel, "Liver").good());
        QVERIFY(segment->putAndInsertString(DCM_SegmentNumber, "1").good());
        DcmItem* content = nullptr;
        QVERIFY(set.findOrCreateSequenceItem(DCM_ContentSequence, content, -2).good());
        QVERIFY(content->putAndInsertString(DCM_TextValue, "Liver").good());
        Deidentifier({}, patient(), "secret").apply(set);
        QCOMPARE(set.tagExists(DCM_ROIName), OFBool(isOwn));
        QCOMPARE(set.tagExists(DCM_ContentSequence), OFBool(isOwn));
        QCOMPARE(segment->tagExists(DCM_SegmentLabel), OFBool(isOwn));
        QVERIFY(segment->tagExists(DCM_SegmentNumber));
        QCOMPARE(set.tagExists(DCM_TextValue, OFTrue), OFBool(isOwn));
    }
}

BURIN_TEST(ConfidentialAttributesTest)

} // namespace confidentialAttributesTest

#include "ConfidentialAttributesTest.moc"
