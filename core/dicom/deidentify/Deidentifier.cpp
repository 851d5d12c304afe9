// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/deidentify/Deidentifier.h"

#include "core/dicom/base/DicomFile.h"
#include "core/dicom/base/NewUid.h"
#include "core/dicom/base/TextsToUtf8.h"
#include "core/dicom/deidentify/DeidentifiedTags.h"
#include "core/dicom/items/ConditionChain.h"
#include "core/dicom/items/PatientHeader.h"
#include "core/dicom/source/ItemWriter.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDate>
#include <QMessageAuthenticationCode>
#include <QRegularExpression>
#include <QUuid>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>

namespace core {

namespace {

constexpr const char* standardRoot = "1.2.840.10008.";

QByteArray keyed(const QByteArray& secret, const QByteArray& text)
{
    return QMessageAuthenticationCode::hash(text, secret, QCryptographicHash::Sha256);
}

void addWords(QStringList& words, const QString& text)
{
    // The last is the blank of Japanese text.
    static const QRegularExpression gaps(QStringLiteral("[\\s^=,\\\\\\x{3000}]+"));
    for (const QString& word : text.split(gaps, Qt::SkipEmptyParts)) {
        if (word.size() > 1 && !words.contains(word, Qt::CaseInsensitive))
            words += word;
    }
}

bool isHalfOfAName(const QString& part)
{
    constexpr std::ptrdiff_t fewest = 3; // shorter ones are articles, titles and initials
    const auto letters =
        std::count_if(part.begin(), part.end(), [](QChar letter) { return letter.isLetter(); });
    return letters >= fewest
        && std::none_of(part.begin(), part.end(), [](QChar letter) { return letter.isDigit(); });
}

/// The words of somebody's name in the form of DICOM (PS3.5 6.2.1), and what else people write of
/// it: half of a double name, and family and given name without a gap, which in Chinese and Korean
/// are often one character each.
void addName(QStringList& words, const QString& name)
{
    addWords(words, name);
    static const QRegularExpression joints(QStringLiteral("[\\s^=,\\\\\\x{3000}\\-_.'\\x{2019}]+"));
    for (const QString& part : name.split(joints, Qt::SkipEmptyParts)) {
        if (isHalfOfAName(part))
            addWords(words, part);
    }
    static const QRegularExpression groups(QStringLiteral("[=\\\\]"));
    static const QRegularExpression blanks(QStringLiteral("[\\s\\x{3000}]+"));
    for (const QString& group : name.split(groups, Qt::SkipEmptyParts)) {
        const QStringList components = group.split(QLatin1Char('^'));
        QString joined = components.value(0) + components.value(1);
        addWords(words, joined.remove(blanks));
    }
}

QRegularExpression patternOf(const QString& word)
{
    const QString quoted = QRegularExpression::escape(word);
    const QString pattern = isSoughtWithinWords(word)
        ? quoted
        : QStringLiteral("(?<![\\p{L}\\p{N}])%1(?![\\p{L}\\p{N}])").arg(quoted);
    return QRegularExpression(pattern,
        QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
}

QString without(QString text, const QStringList& words)
{
    for (const QString& word : words)
        text.remove(patternOf(word));
    return text.simplified();
}

QString textOf(DcmElement& element)
{
    OFString value;
    element.getOFStringArray(value);
    return QString::fromUtf8(value.c_str(), qsizetype(value.size()));
}

void setText(DcmElement& element, const QString& text)
{
    element.putString(text.toUtf8().constData());
}

/// Whom a data set names: people, and the numbers they go by.
void collectWords(DcmItem& item, QStringList& words)
{
    const DcmTagKey numbers[] = {DCM_PatientID, DCM_AccessionNumber, DCM_RETIRED_OtherPatientIDs,
        DCM_InstitutionName, DCM_IssuerOfPatientID};
    for (unsigned long i = 0; i < item.card(); ++i) {
        DcmElement* element = item.getElement(i);
        if (element->ident() == EVR_PN)
            addName(words, textOf(*element));
        else if (std::find(std::begin(numbers), std::end(numbers), element->getTag().getXTag())
            != std::end(numbers))
            addWords(words, textOf(*element));
        auto* sequence = dynamic_cast<DcmSequenceOfItems*>(element);
        for (unsigned long k = 0; sequence != nullptr && k < sequence->card(); ++k)
            collectWords(*sequence->getItem(k), words);
    }
}

} // namespace

bool isSoughtWithinWords(const QString& word)
{
    constexpr qsizetype longEnough = 4;
    return word.size() >= longEnough || std::any_of(word.begin(), word.end(), [](QChar letter) {
        switch (letter.script()) {
        case QChar::Script_Han:
        case QChar::Script_Hiragana:
        case QChar::Script_Katakana:
        case QChar::Script_Hangul:
        case QChar::Script_Thai:
            return true;
        default:
            return false;
        }
    });
}

bool holdsWord(const QString& text, const QString& word)
{
    return isSoughtWithinWords(word) ? text.contains(word, Qt::CaseInsensitive)
                                     : text.contains(patternOf(word));
}

Deidentifier::Deidentifier(
    const DeidentifyOptions& options, const StudyIdentity& patient, QByteArray secret)
    : m_options(options)
    , m_secret(std::move(secret))
{
    if (m_secret.isEmpty())
        m_secret = QUuid::createUuid().toRfc4122() + QUuid::createUuid().toRfc4122();
    const QByteArray whose = patient.patientId.toUtf8() + '\n' + patient.patientName.toUtf8();
    m_patientId = QStringLiteral("ANON-")
        + QString::fromLatin1(keyed(m_secret, "patient\n" + whose).toHex().left(10).toUpper());
    addName(m_words, patient.patientName);
    addWords(m_words, patient.patientId);
    addWords(m_words, patient.accessionNumber);
    QString born = patient.birthDate;
    addWords(m_words, born);
    addWords(m_words, born.remove(QLatin1Char('-')));
    for (const QString& uid : {patient.studyUid, patient.seriesUid, patient.frameOfReferenceUid}) {
        if (!uid.isEmpty())
            m_words += uid;
    }
}

QString Deidentifier::uid(const QString& uid) const
{
    if (uid.isEmpty() || uid.startsWith(QLatin1String(standardRoot)))
        return uid;
    return uidOf(keyed(m_secret, uid.toLatin1()).left(16));
}

QString Deidentifier::date(const QString& date) const
{
    switch (m_options.dates) {
    case DeidentifyOptions::Dates::Keep:
        return date;
    case DeidentifyOptions::Dates::Shift: {
        const QDate day = QDate::fromString(date.left(8), QStringLiteral("yyyyMMdd"));
        return day.isValid()
            ? day.addDays(m_options.shiftDays).toString(QStringLiteral("yyyyMMdd")) + date.mid(8)
            : QString();
    }
    case DeidentifyOptions::Dates::Remove:
        break;
    }
    return {};
}

QString Deidentifier::cleanText(const QString& text) const
{
    return without(text, m_words);
}

QString Deidentifier::method() const
{
    QStringList parts{QStringLiteral("PS3.15 basic profile")};
    switch (m_options.dates) {
    case DeidentifyOptions::Dates::Keep:
        parts += QStringLiteral("dates kept");
        break;
    case DeidentifyOptions::Dates::Shift:
        parts += QStringLiteral("dates shifted");
        break;
    case DeidentifyOptions::Dates::Remove:
        parts += QStringLiteral("dates removed");
        break;
    }
    if (m_options.keepDevice)
        parts += QStringLiteral("device kept");
    if (m_options.keepDescriptions)
        parts += QStringLiteral("descriptions cleaned");
    return parts.join(QStringLiteral("; "));
}

QString Deidentifier::segmentName(int label, const QString& name, const QString& meaning) const
{
    const QString clean = m_options.keepDescriptions ? cleanText(name) : QString();
    if (!clean.isEmpty())
        return clean;
    return meaning.isEmpty() ? QStringLiteral("Segment %1").arg(label) : meaning;
}

SourceHeader Deidentifier::deidentified(SourceHeader header) const
{
    header.patient = {.name = patientName(), .id = patientId(), .birthDate = {}};
    header.studyUid = uid(header.studyUid);
    header.seriesUid = uid(header.seriesUid);
    header.frameOfReferenceUid = uid(header.frameOfReferenceUid);
    header.sopInstanceUid = uid(header.sopInstanceUid);
    return header;
}

StudyIdentity Deidentifier::deidentified(StudyIdentity identity) const
{
    const auto described = [this](const QString& text) {
        return m_options.keepDescriptions ? cleanText(text) : QString();
    };
    QString day = date(QString(identity.studyDate).remove(QLatin1Char('-')));
    if (!day.isEmpty())
        day = day.insert(6, QLatin1Char('-')).insert(4, QLatin1Char('-'));
    return {.patientName = patientName(),
        .patientId = patientId(),
        .birthDate = {},
        .sex = {},
        .studyUid = uid(identity.studyUid),
        .studyDate = day,
        .studyDescription = described(identity.studyDescription),
        .accessionNumber = {},
        .seriesUid = uid(identity.seriesUid),
        .seriesNumber = identity.seriesNumber,
        .seriesDescription = described(identity.seriesDescription),
        .modality = identity.modality,
        .frameOfReferenceUid = uid(identity.frameOfReferenceUid),
        .patientPosition = identity.patientPosition};
}

/// What is the same for all items of one data set.
struct Deidentifier::Pass {
    QStringList words; ///< of the patient's identity
    QStringList settled; ///< UIDs that stay
    bool ours = false; ///< this program made it
};

void Deidentifier::applyToItem(DcmItem& item, const Pass& pass) const
{
    const bool dateless = m_options.dates == DeidentifyOptions::Dates::Remove;
    for (unsigned long i = item.card(); i > 0; --i) {
        DcmElement& element = *item.getElement(i - 1);
        const DcmTagKey tag = element.getTag().getXTag();
        const bool curveOrOverlay =
            (tag.getGroup() & 0xFF00) == 0x5000 || (tag.getGroup() & 0xFF00) == 0x6000;
        if (tag.getGroup() % 2 != 0 || curveOrOverlay || element.ident() == EVR_UN) {
            delete item.remove(i - 1);
            continue;
        }
        if (element.ident() == EVR_UI) {
            QStringList mapped;
            for (const QString& each : textOf(element).split(QLatin1Char('\\')))
                mapped += pass.settled.contains(each) ? each : uid(each);
            setText(element, mapped.join(QLatin1Char('\\')));
            continue;
        }
        bool goes = false;
        const TagFate fate = fateOf(tag);
        switch (fate) {
        case TagFate::Remove:
            goes = true;
            break;
        case TagFate::Keep:
            break;
        case TagFate::Empty:
            setText(element, {});
            break;
        case TagFate::OwnText:
            goes = !pass.ours;
            break;
        case TagFate::Enter:
        case TagFate::OwnItems: {
            auto* sequence = dynamic_cast<DcmSequenceOfItems*>(&element);
            goes = sequence == nullptr || (fate == TagFate::OwnItems && !pass.ours);
            for (unsigned long k = 0; !goes && k < sequence->card(); ++k)
                applyToItem(*sequence->getItem(k), pass);
            break;
        }
        case TagFate::Date:
            goes = dateless;
            if (!goes)
                setText(element, date(textOf(element)));
            break;
        case TagFate::Time:
            goes = dateless;
            break;
        case TagFate::NeededDate:
            if (tag == DCM_ContentDate && dateless)
                setText(element, QStringLiteral("19000101"));
            else
                setText(element, date(textOf(element)));
            break;
        case TagFate::NeededTime:
            if (dateless)
                setText(element, tag == DCM_ContentTime ? QStringLiteral("000000") : QString());
            break;
        case TagFate::Device:
            if (!pass.ours)
                setText(element,
                    m_options.keepDevice ? without(textOf(element), pass.words) : QString());
            break;
        case TagFate::Description:
            goes = !m_options.keepDescriptions;
            if (!goes)
                setText(element, singleValueText(without(textOf(element), pass.words), 64));
            break;
        }
        if (goes)
            delete item.remove(i - 1);
    }
}

void Deidentifier::apply(DcmDataset& set, const QStringList& settled) const
{
    textsToUtf8(set);
    OFString manufacturer;
    set.findAndGetOFString(DCM_Manufacturer, manufacturer);
    Pass pass{.words = m_words, .settled = settled, .ours = manufacturer == "Burin"};
    collectWords(set, pass.words);
    applyToItem(set, pass);

    ConditionChain chain;
    const ItemWriter items(chain);
    completePatientHeader(set, chain);
    items.put(&set, DCM_SpecificCharacterSet, "ISO_IR 192");
    items.put(&set, DCM_PatientName, patientName());
    items.put(&set, DCM_PatientID, patientId());
    items.put(&set, DCM_PatientIdentityRemoved, "YES");
    QString how =
        QStringLiteral("Burin %1; %2").arg(QCoreApplication::applicationVersion(), method());
    items.put(
        &set, DCM_DeidentificationMethod, how.replace(QStringLiteral("; "), QStringLiteral("\\")));
    const auto code = [](const char* value, const char* meaning) {
        return CodedConcept{.scheme = QStringLiteral("DCM"),
            .value = QLatin1String(value),
            .meaning = QLatin1String(meaning)};
    };
    const DcmTagKey codes = DCM_DeidentificationMethodCodeSequence;
    delete set.remove(codes);
    items.putCode(&set, codes, code("113100", "Basic Application Confidentiality Profile"));
    if (m_options.keepDescriptions)
        items.putCode(&set, codes, code("113105", "Clean Descriptors Option"));
    const char* temporal = "REMOVED";
    if (m_options.dates == DeidentifyOptions::Dates::Keep) {
        items.putCode(&set, codes,
            code("113106", "Retain Longitudinal Temporal Information Full Dates Option"));
        temporal = "UNMODIFIED";
    } else if (m_options.dates == DeidentifyOptions::Dates::Shift) {
        items.putCode(&set, codes,
            code("113107", "Retain Longitudinal Temporal Information Modified Dates Option"));
        temporal = "MODIFIED";
    }
    if (m_options.keepDevice)
        items.putCode(&set, codes, code("113109", "Retain Device Identity Option"));
    items.put(&set, DCM_LongitudinalTemporalInformationModified, temporal);
}

} // namespace core
