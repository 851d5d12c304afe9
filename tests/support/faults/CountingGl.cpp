// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/CountingGl.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <QtGlobal>

#include <algorithm>
#include <atomic>

namespace test {

namespace {

std::atomic<int> madeObjects = 0;
std::atomic<int> livingObjects = 0;

void countMade(int count)
{
    madeObjects += count;
    livingObjects += count;
}

/// One function of the driver: the loader's pointer leads to ours meanwhile.
template <class Function> struct Redirection {
    Function* pointer = nullptr;
    Function real = nullptr;

    void begin(Function& loaders, Function ours, const char* name)
    {
        pointer = &loaders;
        real = reinterpret_cast<Function>(eglGetProcAddress(name));
        loaders = ours;
    }
    void end() { *pointer = real; }
};

using MakeMany = void (*)(GLsizei, GLuint*);
using MakeManyOf = void (*)(GLenum, GLsizei, GLuint*);
using DeleteMany = void (*)(GLsizei, const GLuint*);
using DeleteOne = void (*)(GLuint);

template <int Which> Redirection<MakeMany> makeMany;
template <int Which> Redirection<MakeManyOf> makeManyOf;
template <int Which> Redirection<DeleteMany> deleteMany;
template <int Which> Redirection<DeleteOne> deleteOne;
Redirection<GLuint (*)()> makeProgram;
Redirection<GLuint (*)(GLenum)> makeShader;
Redirection<GLsync (*)(GLenum, GLbitfield)> makeFence;
Redirection<void (*)(GLsync)> deleteFence;

template <int Which> void countingMakeMany(GLsizei count, GLuint* names)
{
    makeMany<Which>.real(count, names);
    countMade(count);
}

template <int Which> void countingMakeManyOf(GLenum kind, GLsizei count, GLuint* names)
{
    makeManyOf<Which>.real(kind, count, names);
    countMade(count);
}

/// The name 0 is none, and deleting it is nothing.
template <int Which> void countingDeleteMany(GLsizei count, const GLuint* names)
{
    livingObjects -= count - int(std::count(names, names + count, 0u));
    deleteMany<Which>.real(count, names);
}

template <int Which> void countingDeleteOne(GLuint name)
{
    livingObjects -= name == 0 ? 0 : 1;
    deleteOne<Which>.real(name);
}

GLuint countingProgram()
{
    countMade(1);
    return makeProgram.real();
}

GLuint countingShader(GLenum kind)
{
    countMade(1);
    return makeShader.real(kind);
}

GLsync countingFence(GLenum condition, GLbitfield flags)
{
    countMade(1);
    return makeFence.real(condition, flags);
}

void countingDeleteFence(GLsync fence)
{
    livingObjects -= fence == nullptr ? 0 : 1;
    deleteFence.real(fence);
}

} // namespace

CountingGl::CountingGl()
{
    Q_ASSERT(makeProgram.pointer == nullptr);
    madeObjects = 0;
    livingObjects = 0;
    makeMany<0>.begin(epoxy_glCreateBuffers, countingMakeMany<0>, "glCreateBuffers");
    makeMany<1>.begin(epoxy_glCreateFramebuffers, countingMakeMany<1>, "glCreateFramebuffers");
    makeMany<2>.begin(epoxy_glCreateVertexArrays, countingMakeMany<2>, "glCreateVertexArrays");
    makeMany<3>.begin(epoxy_glGenTextures, countingMakeMany<3>, "glGenTextures");
    makeManyOf<0>.begin(epoxy_glCreateTextures, countingMakeManyOf<0>, "glCreateTextures");
    makeManyOf<1>.begin(epoxy_glCreateQueries, countingMakeManyOf<1>, "glCreateQueries");
    deleteMany<0>.begin(epoxy_glDeleteBuffers, countingDeleteMany<0>, "glDeleteBuffers");
    deleteMany<1>.begin(epoxy_glDeleteFramebuffers, countingDeleteMany<1>, "glDeleteFramebuffers");
    deleteMany<2>.begin(epoxy_glDeleteVertexArrays, countingDeleteMany<2>, "glDeleteVertexArrays");
    deleteMany<3>.begin(epoxy_glDeleteTextures, countingDeleteMany<3>, "glDeleteTextures");
    deleteMany<4>.begin(epoxy_glDeleteQueries, countingDeleteMany<4>, "glDeleteQueries");
    deleteOne<0>.begin(epoxy_glDeleteProgram, countingDeleteOne<0>, "glDeleteProgram");
    deleteOne<1>.begin(epoxy_glDeleteShader, countingDeleteOne<1>, "glDeleteShader");
    makeProgram.begin(epoxy_glCreateProgram, countingProgram, "glCreateProgram");
    makeShader.begin(epoxy_glCreateShader, countingShader, "glCreateShader");
    makeFence.begin(epoxy_glFenceSync, countingFence, "glFenceSync");
    deleteFence.begin(epoxy_glDeleteSync, countingDeleteFence, "glDeleteSync");
}

CountingGl::~CountingGl()
{
    makeMany<0>.end();
    makeMany<1>.end();
    makeMany<2>.end();
    makeMany<3>.end();
    makeManyOf<0>.end();
    makeManyOf<1>.end();
    deleteMany<0>.end();
    deleteMany<1>.end();
    deleteMany<2>.end();
    deleteMany<3>.end();
    deleteMany<4>.end();
    deleteOne<0>.end();
    deleteOne<1>.end();
    makeProgram.end();
    makeShader.end();
    makeFence.end();
    deleteFence.end();
    makeProgram.pointer = nullptr;
}

int CountingGl::made() const
{
    return madeObjects;
}

int CountingGl::living() const
{
    return livingObjects;
}

} // namespace test
