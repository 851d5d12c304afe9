// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/PacsQuery.h"

#include "core/dicom/base/DicomText.h"
#include "core/dicom/base/Preflight.h"
#include "core/dicom/base/TransferSyntax.h"
#include "core/pacs/Association.h"
#include "core/pacs/NodeStatus.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcistrmb.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmnet/dimse.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>

namespace core {

namespace {

/// No answer to a question is longer.
constexpr std::size_t longestAnswer = 4u << 20;

/// What is asked for: tags with the value they are to match.
class Question {
public:
    explicit Question(const char* level) { put(DCM_QueryRetrieveLevel, QLatin1String(level)); }

    void put(const DcmTagKey& tag, const QString& value)
    {
        m_ascii = m_ascii
            && std::all_of(value.begin(), value.end(), [](QChar c) { return c.unicode() < 128; });
        m_set.putAndInsertString(tag, value.toUtf8().constData());
    }
    /// Asked for, whatever it is.
    void want(const DcmTagKey& tag) { m_set.insertEmptyElement(tag); }
    [[nodiscard]] DcmDataset& set()
    {
        if (!m_ascii)
            m_set.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 192");
        return m_set;
    }

private:
    DcmDataset m_set;
    bool m_ascii = true;
};

/// One answer.
class Answer {
public:
    explicit Answer(DcmDataset& set)
        : m_set(set)
    {
        m_characterSet = bytes(DCM_SpecificCharacterSet);
    }

    [[nodiscard]] QString text(const DcmTagKey& tag) const
    {
        return dicomText(bytes(tag), m_characterSet).trimmed();
    }
    [[nodiscard]] QString uid(const DcmTagKey& tag) const { return text(tag).remove(QChar(0)); }
    [[nodiscard]] QString date(const DcmTagKey& tag) const { return dicomDate(text(tag)); }
    [[nodiscard]] int count(const DcmTagKey& tag) const
    {
        bool isNumber = false;
        const int number = text(tag).toInt(&isNumber);
        return isNumber && number >= 0 ? number : -1;
    }

private:
    [[nodiscard]] QByteArray bytes(const DcmTagKey& tag) const
    {
        OFString value;
        if (m_set.findAndGetOFStringArray(tag, value).bad())
            return {};
        return {value.c_str(), qsizetype(value.size())};
    }

    DcmDataset& m_set;
    QByteArray m_characterSet;
};

/// Parses what arrived, once its structure is known to be harmless.
Result<std::unique_ptr<DcmDataset>> parsed(
    QByteArray bytes, const QByteArray& syntaxUid, const QString& nodeName)
{
    const TransferSyntax& syntax = transferSyntax(QString::fromLatin1(syntaxUid));
    const DataSetForm form{.explicitVr = syntax.explicitVr, .bigEndian = syntax.bigEndian};
    const auto size = std::size_t(bytes.size());
    const DicomBytes checked(reinterpret_cast<const std::uint8_t*>(bytes.constData()), size);
    if (const Result<PreflightFacts> facts = preflight(checked, form, nodeName); !facts)
        return failure(ErrorCode::NodeNonsense, nodeName, facts.error().arguments.value(1));
    auto set = std::make_unique<DcmDataset>();
    DcmInputBufferStream stream;
    stream.setBuffer(bytes.data(), bytes.size());
    stream.setEos();
    set->transferInit();
    const OFCondition read = set->read(
        stream, DcmXfer(syntaxUid.constData()).getXfer(), EGL_noChange, DCM_MaxReadLength);
    set->transferEnd();
    if (read.bad() && read != EC_EndOfStream)
        return failure(ErrorCode::NodeNonsense, nodeName, QString::fromUtf8(read.text()));
    return set;
}

/// Asks, and hands over answer after answer until @p take wants no more.
Result<void> ask(const PacsNode& node, Question& question, const Progress& progress,
    const std::function<bool(const Answer&)>& take)
{
    const QByteArray model = UID_FINDStudyRootQueryRetrieveInformationModel;
    Result<Association> association = Association::request(
        node, {{model, plainSyntaxes()}}, progress, Patience::ofQuestion(node.timeoutSeconds));
    if (!association)
        return tl::unexpected<Error>(association.error());
    const Result<std::uint8_t> context = association->context(model);
    if (!context)
        return tl::unexpected<Error>(context.error());
    T_DIMSE_Message request{};
    request.CommandField = DIMSE_C_FIND_RQ;
    request.msg.CFindRQ.MessageID = association->nextMessageId();
    std::strcpy(request.msg.CFindRQ.AffectedSOPClassUID, model.constData());
    request.msg.CFindRQ.Priority = DIMSE_PRIORITY_MEDIUM;
    request.msg.CFindRQ.DataSetType = DIMSE_DATASET_PRESENT;
    if (Result<void> sent = association->send(*context, request, &question.set()); !sent)
        return sent;
    const QByteArray syntax = association->transferSyntax(*context);
    bool wanted = true;
    for (int answers = 0;; ++answers) {
        if (answers > mostAnswers)
            return failure(
                ErrorCode::NodeNonsense, node.name(), Clause::saying("its list has no end"));
        std::uint8_t number = 0;
        const Result<T_DIMSE_Message> message = association->receive(number);
        if (!message)
            return tl::unexpected<Error>(message.error());
        if (message->CommandField != DIMSE_C_FIND_RSP)
            return failure(ErrorCode::NodeNonsense, node.name(), Clause::saying("no answer"));
        const T_DIMSE_C_FindRSP& response = message->msg.CFindRSP;
        QByteArray bytes;
        if (response.DataSetType != DIMSE_DATASET_NULL) {
            const Result<void> received =
                association->receiveData(number, [&bytes](const char* part, std::size_t size) {
                    if (std::size_t(bytes.size()) + size <= longestAnswer)
                        bytes.append(part, qsizetype(size));
                });
            if (!received)
                return received;
        }
        if (!DICOM_PENDING_STATUS(response.DimseStatus)) {
            association->release();
            const bool calledOff = !wanted && response.DimseStatus == 0xfe00;
            if (response.DimseStatus != 0 && !calledOff) {
                return failure(ErrorCode::NodeFailed, node.name(), Clause::saying("the search"),
                    statusText(response.DimseStatus));
            }
            return {};
        }
        if (!wanted)
            continue;
        const Result<std::unique_ptr<DcmDataset>> set = parsed(bytes, syntax, node.name());
        if (!set)
            return tl::unexpected<Error>(set.error());
        wanted = take(Answer(**set));
        if (!wanted)
            DIMSE_sendCancelRequest(association->get(), *context, request.msg.CFindRQ.MessageID);
    }
}

} // namespace

Result<void> echoNode(const PacsNode& node, const Progress& progress)
{
    const QByteArray verification = UID_VerificationSOPClass;
    Result<Association> association = Association::request(
        node, {{verification, plainSyntaxes()}}, progress, Patience::Seconds(node.timeoutSeconds));
    if (!association)
        return tl::unexpected<Error>(association.error());
    DIC_US status = 0;
    DcmDataset* detail = nullptr;
    const OFCondition answered = DIMSE_echoUser(association->get(), association->nextMessageId(),
        DIMSE_NONBLOCKING, node.timeoutSeconds, &status, &detail);
    delete detail;
    if (answered.bad())
        return tl::unexpected<Error>(association->error(answered));
    association->release();
    if (status != 0) {
        return failure(
            ErrorCode::NodeFailed, node.name(), Clause::saying("the echo"), statusText(status));
    }
    return {};
}

Result<HitList<StudyHit>> findStudies(
    const PacsNode& node, const StudyFilter& filter, int most, const Progress& progress)
{
    Question question("STUDY");
    question.put(DCM_PatientName, filter.patientName);
    question.put(DCM_PatientID, filter.patientId);
    question.put(DCM_StudyDate, filter.studyDate);
    question.put(DCM_ModalitiesInStudy, filter.modality);
    question.put(DCM_AccessionNumber, filter.accessionNumber);
    question.put(DCM_StudyDescription, filter.description);
    question.put(DCM_StudyInstanceUID, filter.studyUid);
    for (const DcmTagKey& tag : {DCM_PatientBirthDate, DCM_StudyTime,
             DCM_NumberOfStudyRelatedSeries, DCM_NumberOfStudyRelatedInstances})
        question.want(tag);
    HitList<StudyHit> list;
    const Result<void> asked = ask(node, question, progress, [&](const Answer& answer) {
        if (int(list.hits.size()) == most) {
            list.more = true;
            return false;
        }
        list.hits.push_back({.studyUid = answer.uid(DCM_StudyInstanceUID),
            .patientName = answer.text(DCM_PatientName),
            .patientId = answer.text(DCM_PatientID),
            .birthDate = answer.date(DCM_PatientBirthDate),
            .studyDate = answer.date(DCM_StudyDate),
            .accessionNumber = answer.text(DCM_AccessionNumber),
            .description = answer.text(DCM_StudyDescription),
            .modalities =
                answer.text(DCM_ModalitiesInStudy).split(QLatin1Char('\\'), Qt::SkipEmptyParts),
            .series = answer.count(DCM_NumberOfStudyRelatedSeries),
            .instances = answer.count(DCM_NumberOfStudyRelatedInstances)});
        progress.report(ProgressStep::Searching, int(list.hits.size()), 0);
        return true;
    });
    if (!asked)
        return tl::unexpected<Error>(asked.error());
    return list;
}

Result<std::vector<SeriesHit>> findSeries(
    const PacsNode& node, const QString& studyUid, const Progress& progress)
{
    Question question("SERIES");
    question.put(DCM_StudyInstanceUID, studyUid);
    for (const DcmTagKey& tag : {DCM_SeriesInstanceUID, DCM_Modality, DCM_SeriesNumber,
             DCM_SeriesDescription, DCM_BodyPartExamined, DCM_NumberOfSeriesRelatedInstances})
        question.want(tag);
    std::vector<SeriesHit> hits;
    const Result<void> asked = ask(node, question, progress, [&](const Answer& answer) {
        hits.push_back({.studyUid = studyUid,
            .seriesUid = answer.uid(DCM_SeriesInstanceUID),
            .modality = answer.text(DCM_Modality),
            .number = answer.text(DCM_SeriesNumber),
            .description = answer.text(DCM_SeriesDescription),
            .bodyPart = answer.text(DCM_BodyPartExamined),
            .instances = answer.count(DCM_NumberOfSeriesRelatedInstances)});
        return true;
    });
    if (!asked)
        return tl::unexpected<Error>(asked.error());
    std::stable_sort(hits.begin(), hits.end(),
        [](const SeriesHit& a, const SeriesHit& b) { return a.number.toInt() < b.number.toInt(); });
    return hits;
}

Result<std::vector<InstanceHit>> findInstances(const PacsNode& node, const QString& studyUid,
    const QString& seriesUid, const Progress& progress)
{
    Question question("IMAGE");
    question.put(DCM_StudyInstanceUID, studyUid);
    question.put(DCM_SeriesInstanceUID, seriesUid);
    question.want(DCM_SOPInstanceUID);
    question.want(DCM_SOPClassUID);
    question.want(DCM_InstanceNumber);
    std::vector<InstanceHit> hits;
    const Result<void> asked = ask(node, question, progress, [&](const Answer& answer) {
        InstanceHit hit{.sopInstanceUid = answer.uid(DCM_SOPInstanceUID),
            .sopClassUid = answer.uid(DCM_SOPClassUID),
            .number = answer.count(DCM_InstanceNumber)};
        if (!hit.sopInstanceUid.isEmpty())
            hits.push_back(std::move(hit));
        return true;
    });
    // Half a list would be taken for the whole of it.
    const bool listsNone = hits.empty() && !asked && asked.error().code == ErrorCode::NodeFailed;
    if (!asked && !listsNone)
        return tl::unexpected<Error>(asked.error());
    return hits;
}

} // namespace core
