// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/items/PatientHeader.h"

#include "core/dicom/base/DicomText.h"

#include <QDate>
#include <QRegularExpression>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <array>
#include <optional>

namespace core {

namespace {

enum class Kind { Name, LongText, ShortText, Date, Time, Sex, Age, Decimal, Uid };

struct Attribute {
    DcmTagKey tag;
    const char* name;
    Kind kind;
};

const std::array<Attribute, 15> attributes{{
    {DCM_PatientName, "Patient's Name", Kind::Name},
    {DCM_PatientID, "Patient ID", Kind::LongText},
    {DCM_PatientBirthDate, "Patient's Birth Date", Kind::Date},
    {DCM_PatientSex, "Patient's Sex", Kind::Sex},
    {DCM_PatientAge, "Patient's Age", Kind::Age},
    {DCM_PatientSize, "Patient's Size", Kind::Decimal},
    {DCM_PatientWeight, "Patient's Weight", Kind::Decimal},
    {DCM_StudyInstanceUID, "Study Instance UID", Kind::Uid},
    {DCM_StudyDate, "Study Date", Kind::Date},
    {DCM_StudyTime, "Study Time", Kind::Time},
    {DCM_ReferringPhysicianName, "Referring Physician's Name", Kind::Name},
    {DCM_StudyID, "Study ID", Kind::ShortText},
    {DCM_AccessionNumber, "Accession Number", Kind::ShortText},
    {DCM_StudyDescription, "Study Description", Kind::LongText},
    {DCM_FrameOfReferenceUID, "Frame of Reference UID", Kind::Uid},
}};

std::optional<QString> asDate(QString text)
{
    text.remove(QRegularExpression(QStringLiteral("[.\\-/ ]")));
    if (!QDate::fromString(text, QStringLiteral("yyyyMMdd")).isValid())
        return std::nullopt;
    return text;
}

std::optional<QString> asTime(QString text)
{
    text.remove(QLatin1Char(':'));
    static const QRegularExpression pattern(
        QStringLiteral("^([01][0-9]|2[0-3])([0-5][0-9]([0-5][0-9]|60)?)?$|"
                       "^([01][0-9]|2[0-3])[0-5][0-9]([0-5][0-9]|60)\\.[0-9]{1,6}$"));
    if (!pattern.match(text).hasMatch())
        return std::nullopt;
    return text;
}

std::optional<QString> asSex(const QString& text)
{
    const QString first = text.left(1).toUpper();
    const QString word = text.toUpper();
    if (word == first
        && (first == QLatin1String("M") || first == QLatin1String("F")
            || first == QLatin1String("O")))
        return first;
    if (word == QLatin1String("MALE") || word == QLatin1String("FEMALE")
        || word == QLatin1String("OTHER"))
        return first;
    return std::nullopt;
}

std::optional<QString> asAge(const QString& text)
{
    static const QRegularExpression pattern(QStringLiteral("^([0-9]{1,3})([DWMY])$"));
    const auto match = pattern.match(text.toUpper());
    if (!match.hasMatch())
        return std::nullopt;
    return match.captured(1).rightJustified(3, QLatin1Char('0')) + match.captured(2);
}

std::optional<QString> asName(const QString& text)
{
    // At most three groups of at most five components (PS3.5 6.2.1).
    QStringList groups = singleValueText(text, 10'000).split(QLatin1Char('='));
    if (groups.size() > 3)
        return std::nullopt;
    for (const QString& group : groups) {
        if (group.count(QLatin1Char('^')) > 4 || group.size() > 64)
            return std::nullopt;
    }
    return groups.join(QLatin1Char('='));
}

/// The value as DICOM allows it; none if there is no way to say it.
std::optional<QString> normalised(const QString& text, Kind kind)
{
    const auto bounded = [&](int length) -> std::optional<QString> {
        const QString clean = singleValueText(text, 10'000);
        return clean.size() <= length ? std::optional(clean) : std::nullopt;
    };
    switch (kind) {
    case Kind::Name:
        return asName(text);
    case Kind::LongText:
        return bounded(64);
    case Kind::ShortText:
        return bounded(16);
    case Kind::Date:
        return asDate(text);
    case Kind::Time:
        return asTime(text);
    case Kind::Sex:
        return asSex(text);
    case Kind::Age:
        return asAge(text);
    case Kind::Decimal:
        return DcmDecimalString::checkStringValue(text.toStdString(), "1").good()
            ? std::optional(text)
            : std::nullopt;
    case Kind::Uid:
        return DcmUniqueIdentifier::checkStringValue(text.toStdString(), "1").good()
            ? std::optional(text)
            : std::nullopt;
    }
    return std::nullopt;
}

bool isText(Kind kind)
{
    return kind == Kind::Name || kind == Kind::LongText || kind == Kind::ShortText;
}

} // namespace

QString singleValueText(const QString& text, int length)
{
    QString clean;
    for (const QChar character : text) {
        if (character.category() != QChar::Other_Control && character != QLatin1Char('\\'))
            clean += character;
    }
    return clean.trimmed().left(length).trimmed();
}

QString keptPatientName(const QString& name)
{
    return normalised(name, Kind::Name).value_or(QString());
}

QString keptPatientId(const QString& id)
{
    return normalised(id, Kind::LongText).value_or(QString());
}

tl::expected<std::unique_ptr<DcmDataset>, Clause> cleanPatientHeader(
    DcmDataset& source, ReportLines& notes)
{
    const auto bytesOf = [&](const DcmTagKey& tag) {
        OFString value;
        source.findAndGetOFStringArray(tag, value);
        return QByteArray(value.data(), qsizetype(value.size()));
    };
    const QByteArray characterSet = bytesOf(DCM_SpecificCharacterSet);
    auto header = std::make_unique<DcmDataset>();
    header->putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 192");
    for (const Attribute& attribute : attributes) {
        const QByteArray bytes = bytesOf(attribute.tag);
        QString text =
            isText(attribute.kind) ? dicomText(bytes, characterSet) : QString::fromLatin1(bytes);
        while (text.endsWith(QChar(0)))
            text.chop(1);
        text = text.trimmed();
        if (text.isEmpty())
            continue;
        const QString name = QLatin1String(attribute.name);
        const auto clean = normalised(text, attribute.kind);
        if (!clean) {
            if (attribute.kind == Kind::Uid)
                return tl::unexpected(Clause::saying("its %1 is not valid", name));
            notes += ReportSentence{ReportCode::ValueLeftOut, {name}};
            continue;
        }
        if (*clean != text)
            notes += ReportSentence{ReportCode::ValueNormalised, {name}};
        header->putAndInsertString(attribute.tag, clean->toStdString().c_str());
    }
    if (!header->tagExists(DCM_StudyInstanceUID))
        return tl::unexpected(Clause::saying("it has no Study Instance UID"));
    return header;
}

void completePatientHeader(DcmDataset& set, ConditionChain& chain)
{
    for (const DcmTagKey& tag :
        {DCM_PatientName, DCM_PatientID, DCM_PatientBirthDate, DCM_PatientSex, DCM_StudyDate,
            DCM_StudyTime, DCM_ReferringPhysicianName, DCM_StudyID, DCM_AccessionNumber}) {
        if (!set.tagExists(tag))
            chain(set.insertEmptyElement(tag), "empty attribute");
    }
}

} // namespace core
