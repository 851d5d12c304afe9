// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/WebRetrieve.h"

#include "core/dicomweb/WebConnection.h"
#include "core/dicomweb/WebIntake.h"
#include "core/dicomweb/WebQuery.h"
#include "core/pacs/retrieve/DownloadFolder.h"
#include "core/pacs/retrieve/RetrievePlan.h"

#include <algorithm>
#include <optional>

namespace core {

namespace {

QByteArray pathOfSeries(const QString& studyUid, const QString& seriesUid)
{
    return "/studies/" + studyUid.toLatin1() + "/series/" + seriesUid.toLatin1();
}

/// One answer.
Result<void> fetch(WebConnection& connection, const QByteArray& path, WebIntake& intake)
{
    // As they are stored: nothing is converted on the way.
    const Result<WebAnswer> answer =
        connection.get(path, "multipart/related; type=\"application/dicom\"; transfer-syntax=*",
            Clause::saying("the download"), intake, false);
    if (!answer)
        return tl::unexpected<Error>(answer.error());
    return intake.end();
}

/// What did not come and the intake does not await, since it is not listed.
struct Unlisted {
    qsizetype objects = 0; ///< at least
    QString series; ///< the first of which nothing came
};

/// A series that is not listed completely.
Result<void> fetchUnlisted(WebConnection& connection, const QByteArray& path,
    const RetrievePlan::Series& series, WebIntake& intake, Unlisted& missing)
{
    const int before = intake.accepted();
    Result<void> fetched = fetch(connection, path, intake);
    if (!fetched && fetched.error().code != ErrorCode::NodeHasNone)
        return fetched;
    const int came = intake.accepted() - before;
    const qsizetype awaited = std::count_if(series.missing.begin(), series.missing.end(),
        [&](const QString& uid) { return intake.missing().contains(uid); });
    missing.objects += std::max<qsizetype>(came == 0 ? 1 : 0, series.counted - came - awaited);
    if (came == 0 && missing.series.isEmpty())
        missing.series = series.seriesUid;
    return fetched;
}

/// Whatever of a series is still missing.
Result<void> fetchSeries(WebConnection& connection, const QString& studyUid,
    const RetrievePlan::Series& series, WebIntake& intake, Unlisted& missing)
{
    const QByteArray path = pathOfSeries(studyUid, series.seriesUid);
    if (!series.isListed())
        return fetchUnlisted(connection, path, series, intake, missing);
    const auto isMissing = [&](const QString& uid) { return intake.missing().contains(uid); };
    const bool isWhole =
        series.asWhole() && std::all_of(series.missing.begin(), series.missing.end(), isMissing);
    if (isWhole)
        return fetch(connection, path, intake);
    for (const QString& uid : series.missing) {
        if (!isMissing(uid))
            continue;
        Result<void> fetched = fetch(connection, path + "/instances/" + uid.toLatin1(), intake);
        // It does not have every object that it lists: the others come nevertheless.
        if (!fetched && fetched.error().code != ErrorCode::NodeHasNone)
            return fetched;
    }
    return {};
}

Result<void> fetchAll(
    WebConnection& connection, const RetrievePlan& plan, WebIntake& intake, Unlisted& missing)
{
    missing = {};
    std::optional<Error> none;
    for (const RetrievePlan::Series& series : plan.series) {
        if (series.isHere())
            continue;
        const Result<void> fetched =
            fetchSeries(connection, plan.studyUid, series, intake, missing);
        if (fetched)
            continue;
        if (fetched.error().code != ErrorCode::NodeHasNone)
            return fetched;
        // The other series come nevertheless.
        if (!none)
            none = fetched.error();
    }
    const bool isPartlyHere = intake.received() > 0
        || std::any_of(plan.series.begin(), plan.series.end(), [](const auto& series) {
               return std::size_t(series.missing.size()) < series.instances.size();
           });
    // What of it is missing where some is here, intake and @p missing know.
    if (none && !isPartlyHere)
        return tl::unexpected<Error>(*none);
    return {};
}

/// Takes a connection that ended up again, as long as that brings something.
Result<void> fetchPatiently(
    WebConnection& connection, const RetrievePlan& plan, WebIntake& intake, Unlisted& missing)
{
    const WebNode& node = connection.node();
    int retries = 0;
    int pauseMs = node.firstPauseMs;
    for (;;) {
        const int before = intake.received();
        Result<void> fetched = fetchAll(connection, plan, intake, missing);
        if (fetched || fetched.error().code != ErrorCode::NodeLost)
            return fetched;
        if (intake.received() > before) {
            retries = 0;
            pauseMs = node.firstPauseMs;
        }
        if (++retries > node.retries)
            return fetched;
        if (Result<void> waited = connection.pause(pauseMs); !waited)
            return waited;
        pauseMs *= 2;
    }
}

/// @param total of objects; 0: nobody could list or count them before
tl::unexpected<Error> incomplete(
    const WebNode& node, const WebIntake& intake, const Unlisted& unlisted, qsizetype total)
{
    const qsizetype missing = std::max<qsizetype>(1, intake.missing().size() + unlisted.objects);
    Error error{ErrorCode::TransferIncomplete,
        {node.name(),
            total > 0 ? QStringLiteral("%1 of %2").arg(missing).arg(total)
                      : QString::number(missing)}};
    if (intake.refusal())
        error.arguments.append(intake.refusal()->arguments.value(1));
    else if (!unlisted.series.isEmpty())
        error.arguments.append(Clause::saying("nothing came of series %1", unlisted.series));
    return tl::unexpected<Error>(error);
}

} // namespace

Result<Retrieved> retrieve(
    const WebNode& node, const RetrieveWish& wish, const QString& target, const Progress& progress)
{
    return retrieveInto(target, listingOf(node, progress, true), wish,
        [&](const RetrievePlan& plan, const DownloadFolder& folder) -> Result<int> {
            Result<WebConnection> connection = WebConnection::open(node, progress);
            if (!connection)
                return tl::unexpected<Error>(connection.error());
            WebIntake intake(folder, plan.missing(), !plan.isKnown(), node.name(), progress);
            Unlisted unlisted;
            const Result<void> fetched = fetchPatiently(*connection, plan, intake, unlisted);
            if (!fetched)
                return tl::unexpected<Error>(fetched.error());
            if (!intake.missing().isEmpty() || unlisted.objects > 0 || intake.refusal()
                || intake.received() == 0)
                return incomplete(node, intake, unlisted, plan.total());
            return intake.received();
        });
}

} // namespace core
