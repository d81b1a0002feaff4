@rem Runs the Gradle release that gradle\wrapper\gradle-wrapper.properties names, as gradlew does; see gradle\Wrapper.java.
@echo off
setlocal
set "JAVA=java"
if defined JAVA_HOME set "JAVA=%JAVA_HOME%\bin\java"
"%JAVA%" "-Dcarom.root=%~dp0." "%~dp0gradle\Wrapper.java" %*
exit /b %ERRORLEVEL%
