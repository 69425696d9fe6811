// Is what each translation unit of a program has been compiled with what it does?
bool takes_threads_with_tbb(unsigned threads);
bool takes_threads_without_tbb(unsigned threads);

int main() {
  const bool is_right = takes_threads_with_tbb(2) && !takes_threads_without_tbb(2) &&
                        takes_threads_with_tbb(1) && takes_threads_without_tbb(1);
  return is_right ? 0 : 1;
}
