"""Names that C libraries have taken, and what becomes of ours that are the same.

Generated functions are called `<mechanism>_<function>` and clash with nothing. What stands alone does: a mechanism
names a header and a namespace of C++, a run-time parameter a member of a struct. A header like one of the system's
is refused; a namespace like a function, and a member like a macro, get an underscore.

Sources: ISO C11, chapter 7; what glibc declares in its headers of ISO C, unistd.h, strings.h, fcntl.h, sys/stat.h and
pthread.h by default (`gcc -D_GNU_SOURCE -aux-info`, names of plain letters and digits); windows.h.
"""

from __future__ import annotations

from collections.abc import Iterable

_HEADERS = """
    alloca assert complex ctype endian errno fcntl features fenv float immintrin inttypes iso646 limits locale
    malloc math memory omp poll pthread sched semaphore setjmp signal stdalign stdarg stdatomic stdbool stdckdint stddef
    stdint stdio stdlib stdnoreturn string strings syslimits tgmath threads time uchar unistd wchar wctype windows
"""
HEADERS = frozenset(_HEADERS.split())
"""Headers `<name>.h` of the system, which code that looks for headers beside ours must still find."""

DEVICES = frozenset(["aux", "con", "nul", "prn", *(f"{port}{k}" for port in ("com", "lpt") for k in range(1, 10))])
"""What no file on Windows may be called, whatever its suffix."""

_MACROS = """
    BUFSIZ DOMAIN EDOM EILSEQ EOF ERANGE FILENAME_MAX HUGE HUGE_VAL I INFINITY MAXFLOAT NAN OVERFLOW PI PLOSS RAND_MAX
    SING TLOSS TMP_MAX UNDERFLOW acpi assert bool cdecl complex environ errno far hyper i386 imaginary in interface
    linux math_errhandling mips near noreturn out pascal setjmp signgam small sparc stderr stdin stdout sun unix vax
    IN OUT OPTIONAL VOID CONST TRUE FALSE HIGH LOW INPUT OUTPUT DEFAULT
"""
MACROS = frozenset(_MACROS.split())
"""Macros without arguments: of ISO C, of compilers for their machine, of windows.h and of microcontrollers."""

_PER_TYPE = """
    acos acosh asin asinh atan atan2 atanh cabs cacos cacosh canonicalize carg casin casinh catan catanh cbrt ccos
    ccosh ceil cexp cimag clog clog10 conj copysign cos cosh cpow cproj creal csin csinh csqrt ctan ctanh drem erf
    erfc exp exp10 exp2 expm1 fabs fdim finite floor fma fmax fmaximum fmaxmag fmin fminimum fminmag fmod frexp
    fromfp fromfpx gamma getpayload hypot ilogb isinf isnan j0 j1 jn ldexp lgamma llogb llrint llround log log10
    log1p log2 logb lrint lround modf nan nearbyint nextafter nextdown nexttoward nextup pow remainder remquo rint
    round roundeven scalb scalbln scalbn setpayload setpayloadsig significand sin sincos sinh sqrt tan tanh tgamma
    totalorder totalordermag trunc ufromfp ufromfpx y0 y1 yn
"""
PER_TYPE = frozenset(_PER_TYPE.split())
"""Functions of which there is one with f, for float, and one with l, for long double."""

_FUNCTIONS = """
    a64l abort abs accept access acct alarm aligned_alloc alloca arc4random asctime asprintf at_quick_exit atexit
    atof atoi atol atoll basename bcmp bcopy bind brk bsearch btowc bzero c16rtomb c32rtomb c8rtomb call_once calloc
    chdir chmod chown chroot clearenv clearerr clock clone close closefrom cnd_broadcast cnd_destroy cnd_init
    cnd_signal cnd_timedwait cnd_wait confstr connect creat crypt ctermid ctime cuserid daddl daemon ddivl dfmal
    difftime div dmull dprintf drand48 dsqrtl dsubl dup dup2 dup3 duplocale dysize eaccess ecvt endusershell erand48
    euidaccess execl execle execlp execv execve execveat execvp execvpe exit faccessat fadd fallocate fchdir fchmod
    fchmodat fchown fchownat fclose fcloseall fcntl fcvt fdatasync fdiv fdopen feclearexcept fedisableexcept
    feenableexcept fegetenv fegetexcept fegetexceptflag fegetmode fegetround feholdexcept feof feraiseexcept ferror
    fesetenv fesetexcept fesetexceptflag fesetmode fesetround fetestexcept fetestexceptflag feupdateenv fexecve
    fflush ffma ffs ffsl ffsll fgetc fgetpos fgets fgetwc fgetws fileno flockfile fmemopen fmul fopen fopencookie
    fork fpathconf fprintf fputc fputs fputwc fputws fread free freelocale freopen fscanf fseek fseeko fsetpos fsqrt
    fstat fstatat fsub fsync ftell ftello ftruncate ftrylockfile funlockfile futimens fwide fwprintf fwrite fwscanf
    gcvt getc getchar getcpu getcwd getdate getdelim getdomainname getdtablesize getegid getentropy getenv geteuid
    getgid getgroups gethostid gethostname getline getloadavg getlogin getopt getpagesize getpass getpgid getpgrp
    getpid getppid getpt getresgid getresuid getsid getsubopt gettid getuid getumask getusershell getw getwc
    getwchar getwd gmtime grantpt gsignal imaxabs imaxdiv index initstate isalnum isalpha isascii isatty isblank
    iscntrl isctype isdigit isgraph islower isprint ispunct isspace isupper iswalnum iswalpha iswblank iswcntrl
    iswctype iswdigit iswgraph iswlower iswprint iswpunct iswspace iswupper iswxdigit isxdigit jrand48 kill killpg
    l64a labs lchmod lchown lcong48 ldiv link linkat listen llabs lldiv localeconv localtime lockf longjmp lrand48
    lseek lstat malloc mblen mbrlen mbrtoc16 mbrtoc32 mbrtoc8 mbrtowc mbsinit mbsnrtowcs mbsrtowcs mbstowcs mbtowc
    memccpy memchr memcmp memcpy memfrob memmem memmove mempcpy memrchr memset mkdir mkdirat mkdtemp mkfifo mkfifoat
    mknod mknodat mkostemp mkostemps mkstemp mkstemps mktemp mktime mrand48 mtx_destroy mtx_init mtx_lock
    mtx_timedlock mtx_trylock mtx_unlock nanosleep newlocale nice nrand48 open openat pathconf pause pclose perror
    pipe pipe2 poll popen pread printf profil pselect psiginfo psignal ptsname putc putchar putenv puts putw putwc
    putwchar pwrite qecvt qfcvt qgcvt qsort quick_exit raise rand random rawmemchr read readahead readlink
    readlinkat realloc reallocarray realpath recv remove rename renameat renameat2 revoke rewind rindex rmdir
    rpmatch sbrk scanf seed48 select send setbuf setbuffer setdomainname setegid setenv seteuid setgid sethostid
    sethostname setjmp setlinebuf setlocale setlogin setns setpgid setpgrp setregid setresgid setresuid setreuid
    setsid setstate setuid setusershell setvbuf shutdown sigaction sigaddset sigaltstack sigandset sigblock
    sigdelset sigemptyset sigfillset siggetmask sighold sigignore siginterrupt sigisemptyset sigismember siglongjmp
    signal sigorset sigpause sigpending sigprocmask sigqueue sigrelse sigreturn sigset sigsetmask sigstack
    sigsuspend sigtimedwait sigwait sigwaitinfo sleep snprintf socket splice sprintf srand srand48 srandom sscanf
    ssignal stat statx stpcpy stpncpy strcasecmp strcasestr strcat strchr strchrnul strcmp strcoll strcpy strcspn
    strdup strerror strfromd strfromf strfroml strfry strftime strlen strncasecmp strncat strncmp strncpy strndup
    strnlen strpbrk strptime strrchr strsep strsignal strspn strstr strtod strtof strtoimax strtok strtol strtold
    strtoll strtoq strtoul strtoull strtoumax strtouq strverscmp strxfrm swab swprintf swscanf symlink symlinkat
    sync syncfs syscall sysconf system tcgetpgrp tcsetpgrp tee tempnam tgkill thrd_create thrd_current thrd_detach
    thrd_equal thrd_exit thrd_join thrd_sleep thrd_yield time timegm timelocal timespec_get tmpfile tmpnam toascii
    tolower toupper towctrans towlower towupper truncate tss_create tss_delete tss_get tss_set ttyname ttyslot tzset
    ualarm umask ungetc ungetwc unlink unlinkat unlockpt unsetenv unshare uselocale usleep utimensat valloc
    vasprintf vdprintf vfork vfprintf vfscanf vfwprintf vfwscanf vhangup vmsplice vprintf vscanf vsnprintf vsprintf
    vsscanf vswprintf vswscanf vwprintf vwscanf wcpcpy wcpncpy wcrtomb wcscasecmp wcscat wcschr wcschrnul wcscmp
    wcscoll wcscpy wcscspn wcsdup wcsftime wcslen wcsncasecmp wcsncat wcsncmp wcsncpy wcsnlen wcsnrtombs wcspbrk
    wcsrchr wcsrtombs wcsspn wcsstr wcstod wcstof wcstoimax wcstok wcstol wcstold wcstoll wcstombs wcstoq wcstoul
    wcstoull wcstoumax wcstouq wcswcs wcswidth wcsxfrm wctob wctomb wctrans wctype wcwidth wmemchr wmemcmp wmemcpy
    wmemmove wmempcpy wmemset wprintf write wscanf
"""
FUNCTIONS = frozenset(_FUNCTIONS.split())

_OTHERS = "FILE DIR daylight optarg opterr optind optopt posix std timezone tzname"
OTHERS = frozenset(_OTHERS.split())


def taken_as_file(name: str) -> str | None:
    """What a file `<name>.h` or `<name>.c` would be mistaken for, or None; systems differ by case or do not."""
    found = name.lower()
    if found in HEADERS:
        return f"the system's header {found}.h"
    if found in DEVICES:
        return f"the device {found} of Windows"
    return "example.c, which stands beside generated code" if found == "example" else None


def namespace(name: str) -> str:
    """The C++ namespace of a mechanism.

    >>> namespace("crane"), namespace("gamma"), namespace("time_t")
    ('crane', 'gamma_', 'time_t_')
    """
    function = name in FUNCTIONS or name in PER_TYPE or (name[-1:] in ("f", "l") and name[:-1] in PER_TYPE)
    taken = function or name in MACROS or name in OTHERS or name.endswith("_t")
    return f"{name}_" if taken else name


def members(names: Iterable[str]) -> dict[str, str]:
    """Parameter -> member of a struct of C, all different.

    >>> members(["gamma", "I", "I_"])
    {'gamma': 'gamma', 'I': 'I__', 'I_': 'I_'}
    """
    given = list(names)
    result = {}
    for name in given:
        member = name
        while member in MACROS or (member != name and member in given):
            member += "_"
        result[name] = member
    return result
