// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/RefusingGl.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <QtGlobal>

#include <array>
#include <atomic>
#include <random>

#include <execinfo.h>

namespace test {

namespace {

std::atomic<int> countedRefusals = 0;
std::atomic<int> refusals = 0;
std::atomic<int> firstRefused = 0;
std::atomic<bool> onAndOn = false;

std::atomic<bool> paused = false;
std::mt19937 lot;
int leastGap = 0;
int mostGap = 0; ///< 0: not by lot

// Of the one thread that calls GL; others look at them when its work is done.
std::vector<std::uint64_t> allSites;
std::uint64_t wantedSite = 0; ///< 0: calls are refused by their number
std::uint64_t firstRefusedSite = 0;

/// From the wrappers below outwards, far enough to tell by which command of the engine, and of
/// which kernel, an object that makes all its storages in one function was asked for them.
std::uint64_t siteHere()
{
    constexpr int depth = 20;
    std::array<void*, depth> callers{};
    const int count = backtrace(callers.data(), depth);
    constexpr std::uint64_t prime = 1099511628211U; // FNV-1a
    std::uint64_t site = 14695981039346656037U;
    for (int i = 0; i < count; ++i)
        site = (site ^ std::uint64_t(reinterpret_cast<std::uintptr_t>(callers.at(std::size_t(i)))))
            * prime;
    return site == 0 ? 1 : site;
}

bool refusesNext()
{
    if (paused)
        return false;
    const int call = ++countedRefusals;
    const int first = firstRefused;
    const bool counts = first == 0 && wantedSite == 0;
    const bool seeks = wantedSite != 0 && refusals == 0;
    bool refused = (first > 0 && (call == first || (onAndOn && call > first)))
        || (wantedSite != 0 && refusals > 0 && onAndOn);
    // Asked for in one place only, which is part of the answer.
    const bool noted = counts || seeks || (refused && firstRefusedSite == 0);
    const std::uint64_t site = noted ? siteHere() : 0;
    if (counts)
        allSites.push_back(site);
    if (seeks)
        refused = site == wantedSite;
    if (refused && mostGap > 0)
        firstRefused = call + leastGap + int(lot() % unsigned(mostGap - leastGap + 1));
    if (refused && firstRefusedSite == 0)
        firstRefusedSite = site;
    refusals += refused ? 1 : 0;
    return refused;
}

// The driver's functions; the loader's pointers lead to ours meanwhile.
decltype(epoxy_glNamedBufferStorage) bufferStorage = nullptr;
decltype(epoxy_glTextureStorage2D) textureStorage2D = nullptr;
decltype(epoxy_glTextureStorage3D) textureStorage3D = nullptr;
decltype(epoxy_glTextureView) textureView = nullptr;
decltype(epoxy_glMapNamedBufferRange) mapBuffer = nullptr;
decltype(epoxy_glDispatchCompute) dispatch = nullptr;
decltype(epoxy_glDispatchComputeIndirect) dispatchIndirect = nullptr;

decltype(epoxy_glShaderSource) shaderSource = nullptr;

enum class Counted { Storages, Dispatches, Shaders };
std::atomic<Counted> kindCounted = Counted::Storages; ///< all others go through

bool refuses(Counted what = Counted::Storages)
{
    return kindCounted == what && refusesNext();
}

constexpr GLsizeiptr farTooMuch = GLsizeiptr(1) << 61;

void refusingBufferStorage(GLuint buffer, GLsizeiptr bytes, const void* data, GLbitfield flags)
{
    bufferStorage(buffer, refuses() ? farTooMuch : bytes, data, flags);
}

void refusingStorage2D(GLuint texture, GLsizei levels, GLenum format, GLsizei width, GLsizei height)
{
    textureStorage2D(texture, levels, format, refuses() ? -1 : width, height);
}

void refusingStorage3D(
    GLuint texture, GLsizei levels, GLenum format, GLsizei width, GLsizei height, GLsizei depth)
{
    textureStorage3D(texture, levels, format, refuses() ? -1 : width, height, depth);
}

void refusingView(GLuint texture, GLenum target, GLuint original, GLenum format, GLuint minLevel,
    GLuint levels, GLuint minLayer, GLuint layers)
{
    textureView(
        texture, target, refuses() ? ~0u : original, format, minLevel, levels, minLayer, layers);
}

void* refusingMap(GLuint buffer, GLintptr offset, GLsizeiptr length, GLbitfield access)
{
    return mapBuffer(buffer, refuses() ? -1 : offset, length, access);
}

void refusingDispatch(GLuint x, GLuint y, GLuint z)
{
    dispatch(refuses(Counted::Dispatches) ? ~0u : x, y, z);
}

void refusingIndirect(GLintptr offset)
{
    dispatchIndirect(refuses(Counted::Dispatches) ? -4 : offset);
}

void refusingSource(GLuint shader, GLsizei count, const GLchar* const* texts, const GLint* lengths)
{
    const GLchar* wrong = "#version 450\n#error refused\n";
    if (refuses(Counted::Shaders))
        shaderSource(shader, 1, &wrong, nullptr);
    else
        shaderSource(shader, count, texts, lengths);
}

template <class Function>
void exchange(Function& pointer, Function& real, Function refusing, const char* name)
{
    real = reinterpret_cast<Function>(eglGetProcAddress(name));
    pointer = refusing;
}

} // namespace

RefusingGl::RefusingGl(int first, From from)
{
    Q_ASSERT(bufferStorage == nullptr);
    countedRefusals = 0;
    refusals = 0;
    firstRefused = first;
    onAndOn = from == From::OnAndOn;
    mostGap = 0;
    allSites.clear();
    wantedSite = 0;
    firstRefusedSite = 0;
    kindCounted = Counted::Storages;
    exchange(
        epoxy_glNamedBufferStorage, bufferStorage, refusingBufferStorage, "glNamedBufferStorage");
    exchange(epoxy_glTextureStorage2D, textureStorage2D, refusingStorage2D, "glTextureStorage2D");
    exchange(epoxy_glTextureStorage3D, textureStorage3D, refusingStorage3D, "glTextureStorage3D");
    exchange(epoxy_glTextureView, textureView, refusingView, "glTextureView");
    exchange(epoxy_glMapNamedBufferRange, mapBuffer, refusingMap, "glMapNamedBufferRange");
    exchange(epoxy_glDispatchCompute, dispatch, refusingDispatch, "glDispatchCompute");
    exchange(epoxy_glDispatchComputeIndirect, dispatchIndirect, refusingIndirect,
        "glDispatchComputeIndirect");
    exchange(epoxy_glShaderSource, shaderSource, refusingSource, "glShaderSource");
}

RefusingGl::RefusingGl(Dispatch refused)
    : RefusingGl(refused.number)
{
    kindCounted = Counted::Dispatches;
}

RefusingGl::RefusingGl(Shader refused)
    : RefusingGl(refused.number)
{
    kindCounted = Counted::Shaders;
}

RefusingGl::RefusingGl(Site refused, From from)
    : RefusingGl(0, from)
{
    wantedSite = refused.place;
    if (refused.isDispatch)
        kindCounted = Counted::Dispatches;
}

RefusingGl::RefusingGl(std::uint32_t seed, int least, int most)
    : RefusingGl(most)
{
    lot.seed(seed);
    leastGap = least;
    mostGap = most;
}

RefusingGl::~RefusingGl()
{
    epoxy_glNamedBufferStorage = bufferStorage;
    epoxy_glTextureStorage2D = textureStorage2D;
    epoxy_glTextureStorage3D = textureStorage3D;
    epoxy_glTextureView = textureView;
    epoxy_glMapNamedBufferRange = mapBuffer;
    epoxy_glDispatchCompute = dispatch;
    epoxy_glDispatchComputeIndirect = dispatchIndirect;
    epoxy_glShaderSource = shaderSource;
    bufferStorage = nullptr;
}

RefusingGl::Pause::Pause(RefusingGl&)
{
    paused = true;
}

RefusingGl::Pause::~Pause()
{
    paused = false;
}

int RefusingGl::calls() const
{
    return countedRefusals;
}

int RefusingGl::refused() const
{
    return refusals;
}

const std::vector<std::uint64_t>& RefusingGl::sites() const
{
    return allSites;
}

std::uint64_t RefusingGl::refusedSite() const
{
    return firstRefusedSite;
}

} // namespace test
