// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/WebQuery.h"

#include "core/dicom/base/DicomText.h"
#include "core/dicomweb/JsonAnswer.h"
#include "core/dicomweb/JsonSink.h"
#include "core/dicomweb/WebConnection.h"

#include <QSet>
#include <QUrl>

#include <algorithm>
#include <functional>

namespace core {

namespace {

/// The query of an address.
class Question {
public:
    explicit Question(QByteArray path)
        : m_path(std::move(path))
    {
    }
    void match(const char* keyword, const QString& value)
    {
        if (!value.isEmpty())
            add(keyword, QUrl::toPercentEncoding(value, "*"));
    }
    void want(std::initializer_list<const char*> tags)
    {
        for (const char* tag : tags)
            add("includefield", tag);
    }
    [[nodiscard]] QByteArray page(int limit, int offset) const
    {
        return m_path + m_query + (m_query.isEmpty() ? "?" : "&")
            + "limit=" + QByteArray::number(limit) + "&offset=" + QByteArray::number(offset);
    }

private:
    void add(const char* key, const QByteArray& value)
    {
        m_query += (m_query.isEmpty() ? "?" : "&") + QByteArray(key) + "=" + value;
    }

    QByteArray m_path;
    QByteArray m_query;
};

/// Servers that give pages give as much at a time.
constexpr int usualPage = 1000;
/// As much as they let themselves be asked for where they refuse the usual number.
constexpr int smallPage = 200;

/// Whether a server may have refused the length of a page: it finds the request bad, or too large.
bool mayBeTooLong(int status)
{
    return status == 400 || status == 413;
}

/// Asks page by page, since a server may give fewer than it is asked for, and hands over what is
/// new, of bounded number. Pages are long as long as the server allows that, since one that knows
/// none gives the first page only. @param take whether it wants more
Result<void> ask(WebConnection& connection, const Question& question, const char* uidTag,
    int pageSize, const std::function<bool(const JsonAnswer&)>& take)
{
    const QString name = connection.node().name();
    QSet<QString> seen;
    for (int offset = 0;;) {
        JsonSink sink(name, false);
        const Result<WebAnswer> answer = connection.get(question.page(pageSize, offset),
            "application/dicom+json", Clause::saying("the search"), sink, true);
        if (!answer && pageSize > smallPage && mayBeTooLong(connection.lastStatus())) {
            pageSize = smallPage;
            continue;
        }
        if (!answer)
            return tl::unexpected<Error>(answer.error());
        if (answer->status == 204 || sink.bytes().isEmpty())
            return {};
        const Result<QJsonArray> page = jsonAnswers(sink.bytes(), name);
        if (!page)
            return tl::unexpected<Error>(page.error());
        bool isNew = false;
        for (const QJsonValue& value : *page) {
            const JsonAnswer one(value.toObject());
            const QString uid = one.text(uidTag);
            // A server that knows no pages gives the first one for ever.
            if (!isDicomUid(uid) || seen.contains(uid))
                continue;
            seen.insert(uid);
            if (seen.size() > mostAnswers)
                return failure(
                    ErrorCode::NodeNonsense, name, Clause::saying("its list has no end"));
            isNew = true;
            if (!take(one))
                return {};
        }
        if (!isNew)
            return {};
        offset += int(page->size());
    }
}

QByteArray pathOf(const QString& studyUid, const QString& seriesUid = {})
{
    QByteArray path = "/studies/" + studyUid.toLatin1() + "/series";
    if (!seriesUid.isEmpty())
        path += "/" + seriesUid.toLatin1() + "/instances";
    return path;
}

} // namespace

bool isDicomUid(const QString& text)
{
    return !text.isEmpty() && text.size() <= 64 && text[0] != u'.'
        && std::all_of(text.begin(), text.end(),
            [](QChar c) { return (c >= u'0' && c <= u'9') || c == u'.'; });
}

Result<void> echoNode(const WebNode& node, const Progress& progress)
{
    Result<WebConnection> connection =
        WebConnection::open(node, progress, Patience::Seconds(node.timeoutSeconds));
    if (!connection)
        return tl::unexpected<Error>(connection.error());
    JsonSink sink(node.name(), false);
    const Result<WebAnswer> answer = connection->get(
        "/studies?limit=1", "application/dicom+json", Clause::saying("the search"), sink, true);
    if (!answer)
        return tl::unexpected<Error>(answer.error());
    return {};
}

Result<HitList<StudyHit>> findStudies(
    const WebNode& node, const StudyFilter& filter, int most, const Progress& progress)
{
    Result<WebConnection> connection =
        WebConnection::open(node, progress, Patience::ofQuestion(node.timeoutSeconds));
    if (!connection)
        return tl::unexpected<Error>(connection.error());
    Question question("/studies");
    question.match("PatientName", filter.patientName);
    question.match("PatientID", filter.patientId);
    question.match("StudyDate", filter.studyDate);
    question.match("ModalitiesInStudy", filter.modality);
    question.match("AccessionNumber", filter.accessionNumber);
    question.match("StudyDescription", filter.description);
    question.match("StudyInstanceUID", filter.studyUid);
    question.want({"00080061", "00081030", "00100030", "00201206", "00201208"});
    HitList<StudyHit> list;
    // One more than is wanted tells whether there are more.
    const int page = std::min(most, usualPage - 1) + 1;
    const Result<void> asked =
        ask(*connection, question, "0020000D", page, [&](const JsonAnswer& one) {
            if (int(list.hits.size()) == most) {
                list.more = true;
                return false;
            }
            list.hits.push_back({.studyUid = one.text("0020000D"),
                .patientName = one.text("00100010"),
                .patientId = one.text("00100020"),
                .birthDate = dicomDate(one.text("00100030")),
                .studyDate = dicomDate(one.text("00080020")),
                .accessionNumber = one.text("00080050"),
                .description = one.text("00081030"),
                .modalities = one.texts("00080061"),
                .series = one.count("00201206"),
                .instances = one.count("00201208")});
            progress.report(ProgressStep::Searching, int(list.hits.size()), 0);
            return true;
        });
    if (!asked)
        return tl::unexpected<Error>(asked.error());
    return list;
}

Result<std::vector<SeriesHit>> findSeries(
    const WebNode& node, const QString& studyUid, const Progress& progress)
{
    std::vector<SeriesHit> hits;
    if (!isDicomUid(studyUid))
        return hits;
    Result<WebConnection> connection =
        WebConnection::open(node, progress, Patience::ofQuestion(node.timeoutSeconds));
    if (!connection)
        return tl::unexpected<Error>(connection.error());
    Question question(pathOf(studyUid));
    question.want({"0008103E", "00180015", "00201209"});
    const auto take = [&](const JsonAnswer& one) {
        hits.push_back({.studyUid = studyUid,
            .seriesUid = one.text("0020000E"),
            .modality = one.text("00080060"),
            .number = one.text("00200011"),
            .description = one.text("0008103E"),
            .bodyPart = one.text("00180015"),
            .instances = one.count("00201209")});
        return true;
    };
    const Result<void> asked = ask(*connection, question, "0020000E", usualPage, take);
    if (!asked && asked.error().code != ErrorCode::NodeHasNone)
        return tl::unexpected<Error>(asked.error());
    std::stable_sort(hits.begin(), hits.end(),
        [](const SeriesHit& a, const SeriesHit& b) { return a.number.toInt() < b.number.toInt(); });
    return hits;
}

Result<std::vector<InstanceHit>> findInstances(const WebNode& node, const QString& studyUid,
    const QString& seriesUid, const Progress& progress)
{
    std::vector<InstanceHit> hits;
    if (!isDicomUid(studyUid) || !isDicomUid(seriesUid))
        return hits;
    Result<WebConnection> connection =
        WebConnection::open(node, progress, Patience::ofQuestion(node.timeoutSeconds));
    if (!connection)
        return tl::unexpected<Error>(connection.error());
    const Question question(pathOf(studyUid, seriesUid));
    const auto take = [&](const JsonAnswer& one) {
        hits.push_back({.sopInstanceUid = one.text("00080018"),
            .sopClassUid = one.text("00080016"),
            .number = one.count("00200013")});
        return true;
    };
    const Result<void> asked = ask(*connection, question, "00080018", usualPage, take);
    if (!asked && asked.error().code != ErrorCode::NodeHasNone)
        return tl::unexpected<Error>(asked.error());
    return hits;
}

} // namespace core
