#ifndef QUADRILLE_C_FAILURES_H
#define QUADRILLE_C_FAILURES_H

#include <quadrille/quadrille.h>

#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

/// \file
/// No exception leaves a function of C: it becomes a code and a text.

namespace quadrille::internal {

/// A function of the caller has failed.
class FunctionFailed : public std::runtime_error {
public:
  explicit FunctionFailed(const char* name)
      : std::runtime_error(std::string("the function ") + name + " has failed") {}
};

/// Keeps a text, or nothing if there is no memory for it.
inline void keep_text(std::string& text, const char* what) noexcept {
  try {
    text = what;
  } catch (...) {
    text.clear();
  }
}

/// Does a task and returns QUADRILLE_OK. If it throws, returns the code of the exception, and calls
/// keep(text).
template <class Keep, class Task>
std::int32_t code_of(const Keep& keep, Task&& task) noexcept {
  try {
    std::forward<Task>(task)();
    return QUADRILLE_OK;
  } catch (const FunctionFailed& error) {
    keep(error.what());
    return QUADRILLE_FUNCTION_FAILED;
  } catch (const std::bad_alloc&) {
    keep("out of memory");
    return QUADRILLE_OUT_OF_MEMORY;
  } catch (const std::length_error& error) {
    if (std::string_view(error.what())
            .starts_with("quadrille")) { // more than the library can count
      keep(error.what());
      return QUADRILLE_INVALID;
    }
    keep("out of memory"); // more than there are addresses
    return QUADRILLE_OUT_OF_MEMORY;
  } catch (const std::out_of_range& error) {
    keep(error.what());
    return QUADRILLE_OUT_OF_RANGE;
  } catch (const std::logic_error& error) {
    keep(error.what());
    return QUADRILLE_INVALID;
  } catch (const std::exception& error) {
    keep(error.what());
  } catch (...) {
    keep("an unknown error occurred");
  }
  return QUADRILLE_FAILED;
}

/// The same, with the text in a string.
template <class Task>
std::int32_t code_of(std::string& text, Task&& task) noexcept {
  return code_of([&](const char* what) { keep_text(text, what); }, std::forward<Task>(task));
}

/// A text of the caller, which is cut where it is full.
struct CallersText {
  char* begin;
  std::size_t size;

  void operator()(const char* what) const noexcept {
    if (!begin || size == 0)
      return;
    std::strncpy(begin, what, size - 1);
    begin[size - 1] = '\0';
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_C_FAILURES_H
