// SPDX-License-Identifier: Apache-2.0
#include "core/sources/PacsSource.h"

#include "core/dicomweb/WebQuery.h"
#include "core/dicomweb/WebRetrieve.h"
#include "core/dicomweb/WebSend.h"

#include <QDir>
#include <QJsonObject>

#include <algorithm>
#include <utility>

namespace core {

namespace {

QLatin1String key(const char* name)
{
    return QLatin1String(name);
}

QJsonObject toJson(const PacsNode& node)
{
    return {{key("title"), node.aeTitle}, {key("host"), node.host}, {key("port"), node.port},
        {key("ownTitle"), node.ownAeTitle}, {key("timeout"), node.timeoutSeconds},
        {key("authority"), node.tls.authorityFile}, {key("certificate"), node.tls.certificateFile},
        {key("key"), node.tls.keyFile}};
}

QJsonObject toJson(const WebNode& node)
{
    return {{key("url"), node.name()}, {key("loginFile"), node.loginFile},
        {key("timeout"), node.timeoutSeconds}, {key("authority"), node.authorityFile},
        {key("certificate"), node.certificateFile}, {key("key"), node.keyFile}};
}

PacsNode dicomNode(const QJsonObject& json)
{
    PacsNode node{.aeTitle = json[key("title")].toString(),
        .host = json[key("host")].toString(),
        .port = json[key("port")].toInt(),
        .tls = {.authorityFile = json[key("authority")].toString(),
            .certificateFile = json[key("certificate")].toString(),
            .keyFile = json[key("key")].toString()}};
    node.ownAeTitle = json[key("ownTitle")].toString(node.ownAeTitle);
    node.timeoutSeconds = json[key("timeout")].toInt(node.timeoutSeconds);
    return node;
}

WebNode webNode(const QJsonObject& json)
{
    WebNode node = WebNode::parse(json[key("url")].toString()).value_or(WebNode());
    node.loginFile = json[key("loginFile")].toString();
    node.authorityFile = json[key("authority")].toString();
    node.certificateFile = json[key("certificate")].toString();
    node.keyFile = json[key("key")].toString();
    node.timeoutSeconds = json[key("timeout")].toInt(node.timeoutSeconds);
    return node;
}

void dropTls(PacsNode& node)
{
    node.tls = {};
}

void dropTls(WebNode& node)
{
    node.authorityFile.clear();
    node.certificateFile.clear();
    node.keyFile.clear();
}

/// Whether an entry says where a source is. A file for TLS that is missing is told when the source
/// is asked, and can be named then.
bool saysWhere(PacsSource source)
{
    std::visit([](auto& node) { dropTls(node); }, source.node);
    return !source.name.isEmpty() && source.check();
}

} // namespace

QString PacsSource::address() const
{
    return std::visit([](const auto& one) { return one.name(); }, node);
}

Result<PacsSource> PacsSource::parse(const QString& address)
{
    if (WebNode::isAddress(address)) {
        const Result<WebNode> web = WebNode::parse(address);
        if (!web)
            return tl::unexpected<Error>(web.error());
        return PacsSource{.name = {}, .node = *web, .movePort = {}};
    }
    const Result<PacsNode> dicom = PacsNode::parse(address);
    if (!dicom)
        return tl::unexpected<Error>(dicom.error());
    return PacsSource{.name = {}, .node = *dicom, .movePort = {}};
}

Result<void> PacsSource::check() const
{
    if (WebNode::isAddress(name) || (name.contains(u'@') && name.contains(u':'))) {
        return failure(ErrorCode::InvalidField, QStringLiteral("name"),
            Clause::saying("'%1' could be an address", name));
    }
    if (movePort && (*movePort < 1 || *movePort > 65535)) {
        return failure(
            ErrorCode::InvalidField, QStringLiteral("port"), Clause::saying("it is 1 to 65535"));
    }
    return std::visit([](const auto& one) { return one.check(); }, node);
}

QJsonArray toJson(const std::vector<PacsSource>& sources)
{
    QJsonArray all;
    for (const PacsSource& source : sources) {
        QJsonObject json = std::visit([](const auto& one) { return toJson(one); }, source.node);
        json[key("name")] = source.name;
        if (source.movePort)
            json[key("movePort")] = *source.movePort;
        all.append(json);
    }
    return all;
}

std::vector<PacsSource> sourcesFromJson(const QJsonArray& json)
{
    std::vector<PacsSource> all;
    for (const QJsonValue& value : json) {
        const QJsonObject one = value.toObject();
        PacsSource source{.name = one[key("name")].toString(), .node = {}, .movePort = {}};
        if (one.contains(key("url")))
            source.node = webNode(one);
        else
            source.node = dicomNode(one);
        if (one.contains(key("movePort")))
            source.movePort = one[key("movePort")].toInt();
        if (saysWhere(source))
            all.push_back(std::move(source));
    }
    return all;
}

const PacsSource* findSource(const std::vector<PacsSource>& sources, const QString& name)
{
    const auto found = std::find_if(sources.begin(), sources.end(),
        [&](const PacsSource& one) { return one.name.compare(name, Qt::CaseInsensitive) == 0; });
    return found == sources.end() ? nullptr : &*found;
}

Result<void> echoNode(const PacsSource& source, const Progress& progress)
{
    return std::visit([&](const auto& node) { return echoNode(node, progress); }, source.node);
}

Result<HitList<StudyHit>> findStudies(
    const PacsSource& source, const StudyFilter& filter, int most, const Progress& progress)
{
    return std::visit(
        [&](const auto& node) { return findStudies(node, filter, most, progress); }, source.node);
}

Result<std::vector<SeriesHit>> findSeries(
    const PacsSource& source, const QString& studyUid, const Progress& progress)
{
    return std::visit(
        [&](const auto& node) { return findSeries(node, studyUid, progress); }, source.node);
}

Result<Retrieved> retrieve(const PacsSource& source, const RetrieveWish& wish,
    const QString& target, const Progress& progress)
{
    if (const auto* web = std::get_if<WebNode>(&source.node))
        return retrieve(*web, wish, target, progress);
    return retrieve(
        std::get<PacsNode>(source.node), wish, target, {.movePort = source.movePort}, progress);
}

Result<SentObjects> sendFiles(
    const PacsSource& source, const QStringList& files, const Progress& progress)
{
    return std::visit(
        [&](const auto& node) { return sendFiles(node, files, progress); }, source.node);
}

Result<QString> retrieveMiddle(const PacsSource& source, const SeriesHit& series,
    const QString& target, const Progress& progress)
{
    Result<std::vector<InstanceHit>> instances = std::visit(
        [&](const auto& node) {
            return findInstances(node, series.studyUid, series.seriesUid, progress);
        },
        source.node);
    if (!instances)
        return tl::unexpected<Error>(instances.error());
    if (instances->empty())
        return failure(ErrorCode::NodeHasNone, source.address(), QStringLiteral("image"));
    const auto middle = instances->begin() + std::ptrdiff_t(instances->size() / 2);
    std::nth_element(instances->begin(), middle, instances->end(),
        [](const InstanceHit& a, const InstanceHit& b) { return a.number < b.number; });
    const Result<Retrieved> got = retrieve(source,
        {.studyUid = series.studyUid,
            .seriesUid = series.seriesUid,
            .instanceUid = middle->sopInstanceUid},
        target, progress);
    if (!got)
        return tl::unexpected<Error>(got.error());
    const QStringList files = QDir(target).entryList(QDir::Files);
    return files.isEmpty() ? QString() : QDir(target).filePath(files.front());
}

} // namespace core
