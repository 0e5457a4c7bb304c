@echo off
rem The one door to the course on Windows: configures, builds, runs. What needs a Unix shell is in ./course alone.
setlocal
cd /d "%~dp0"
if exist C:\msys64\mingw64\bin\g++.exe set "PATH=C:\msys64\mingw64\bin;%PATH%"
if not defined BOUNCE_PRESET set BOUNCE_PRESET=release
set build=build\%BOUNCE_PRESET%
for %%w in (missing page rest) do set %%w=
if /i "%BOUNCE_LANG:~0,2%"=="ja" echo course: Japanese is spoken by ./course alone; course.cmd goes on in English>&2
rem (Not by shift and %%1, for which = and , part words.)
for /f "tokens=2*" %%a in ("%*") do set rest=%%b
for %%w in (play check reset test plain list) do if "%~1"=="%%w" goto %%w
for %%w in (new site report format) do if "%~1"=="%%w" goto unknown
echo usage: course play [N] [OPTIONS]    the demo of stage N, or the last one: course play 3 --set stiffness=2000
echo        course play N --mine         the same on your own stages\NN_name\mine.hpp
echo        course check [N]             check your own work: stage N, or the first one not yet done; or: check loop
echo        course reset N               a fresh mine.hpp; the old one is kept beside it
echo        course test                  build and run the tests
echo        course plain N [WORDS]       stage N on one page, plain.cpp: its rows as CSV
echo        course list                  the stages
echo In the window MINGW64 of MSYS2 there is ./course, too. It can do more, but check only here.
if "%~1"=="" exit /b 0
exit /b 2

:plain
set page=_plain
if "%~3"=="--picture" goto unknown
:play
if "%~3"=="--mine" if not defined page goto mine
call :stage_named %2
if not errorlevel 1 call :make %stage%%page%
if not errorlevel 1 %build%\bin\%stage%%page%.exe %rest%
exit /b %errorlevel%
:mine
for /f "tokens=3*" %%a in ("%*") do set rest=%%b
call :stage_named %2
if errorlevel 1 exit /b 2
call :stage
if not exist %mine% echo course: stage %2 has no mine.hpp yet: course check %2 makes it>&2& exit /b 2
call :need cmake.exe
if not errorlevel 1 cmake -DSTAGE=%stage% -DOUT=%build:\=/%/mine/%stage% -P tests/checks/forward.cmake
if not errorlevel 1 call :make %stage%_mine_whole
if not errorlevel 1 %build%\bin\%stage%_mine_whole.exe %rest%
exit /b %errorlevel%
:test
if not "%~2"=="" goto unknown
call :make all
if not errorlevel 1 ctest --test-dir %build% -LE long -j 2 --output-on-failure
exit /b %errorlevel%
:list
for /d %%d in (stages\??_*) do for /f "tokens=2 delims={}" %%a in ('find "demo.stage =" ^< %%d\main.cpp') do echo %%a
exit /b %errorlevel%
:check
for %%w in (plan --hint --watch --report) do if "%~2"=="%%w" goto unknown
if not "%~3"=="" goto unknown
if "%~2"=="" call :next
if not "%~2"=="" call :exercise_named %2
if not errorlevel 1 call :need g++.exe cmake.exe ninja.exe
if errorlevel 1 exit /b %errorlevel%
if "%stage%"=="" echo All stages are done.& exit /b 0
if not exist %mine% call :begin
echo %stage%: %mine%
if not exist build mkdir build
call :make stage_checks %course% %stage%_judged >build\check.log 2>&1
if errorlevel 1 goto not_compiled
if defined course set course=--course %build%\checks\%course%.dll
%build%\bin\stage_checks.exe %stage% %build%\checks\%stage%_judged.dll %course%
if errorlevel 1 goto failed
echo yes>%mine%.passed
if "%stage%"=="loop" set stage=02
echo   See it move:  course play %stage:~0,2% --mine
call :next
if defined stage echo   Next: docs\%stage%.md, then  course check
exit /b 0
:not_compiled
echo   It does not compile yet. The first thing that the compiler does not understand (all: build\check.log):
find "error: " <build\check.log
:failed
if exist %mine%.passed del %mine%.passed
echo   Stuck? Hints, one after the other: %hints%
exit /b 1
:reset
if "%~2"=="" echo course: reset takes one stage: course reset N>&2& exit /b 2
call :exercise_named %2
if errorlevel 1 exit /b 2
if not exist %mine% goto begin
set n=1
:taken
if exist %mine%.%n% set /a n+=1& goto taken
move %mine% %mine%.%n% >nul
if exist %mine%.passed del %mine%.passed
echo Your old file is kept: %mine%.%n%
:begin
call :need cmake.exe
if errorlevel 1 exit /b 1
set header=02_spring_floor/own_method/my_method.hpp
set gaps=%header%
if not "%stage%"=="loop" for /f "tokens=3" %%h in ('find "define BOUNCE_STAGE_HEADER" ^< tests\checks\subjects\%stage%.cpp') do set header=%%~h
if not "%stage%"=="loop" set gaps=%stage%/gaps.hpp
cmake -DBASE=stages/%header% -DPIECES=stages/%gaps% -DOUT=%mine:\=/% -P tests/checks/splice.cmake
if errorlevel 1 exit /b 1
echo Your turn. Edit this file:  %mine%  (its gaps are marked YOUR TURN). Then  course check  again.
exit /b %errorlevel%
:unknown
echo course: '%*' is not known to course.cmd; ./course on Debian or Ubuntu knows it>&2
exit /b 2
:stage_named
set stage=
for /d %%d in (stages\0%~1_* stages\%~1_* stages\??_%~1) do set stage=%%~nxd
if "%~1"=="" for /d %%d in (stages\??_*) do set stage=%%~nxd
if "%stage%"=="" if exist "stages\%~1\main.cpp" set stage=%~1
if not "%stage%"=="" if exist stages\%stage%\main.cpp exit /b 0
echo course: there is no stage '%~1' in this copy; see  course list>&2
exit /b 2
:exercise_named
set stage=loop
set mine=stages\02_spring_floor\mine_method.hpp
set hints=stages\02_spring_floor\own_method\hints.txt
set course=
if "%~1"=="loop" exit /b 0
call :stage_named %1
if errorlevel 1 exit /b 2
:stage
set mine=stages\%stage%\mine.hpp
set hints=stages\%stage%\hints.txt
set course=%stage%_course
exit /b 0
:next
set stage=
for /d %%d in (stages\??_*) do if not defined stage if not exist %%d\mine.hpp.passed set stage=%%~nxd
goto stage
:make
call :need g++.exe cmake.exe ninja.exe
if errorlevel 1 exit /b 1
if not exist %build%\build.ninja cmake --preset %BOUNCE_PRESET%
cmake --build --preset %BOUNCE_PRESET% --target %*
exit /b %errorlevel%
:need
for %%p in (%*) do if "%%~$PATH:p"=="" set missing=%%p
if not defined missing exit /b 0
echo course: %missing% is missing. Install MSYS2 (winget install MSYS2.MSYS2), then in its window MINGW64:>&2
echo   pacman -S mingw-w64-x86_64-{gcc,cmake,ninja,pkgconf,eigen3,cli11,doctest,SDL2,imgui,libpng}>&2
exit /b 1
